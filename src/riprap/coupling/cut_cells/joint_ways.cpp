// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/cut_cells/joint_ways.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "riprap/fluid/grid/datum.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::Mesh;

/// A bit for each side of a cell, low and high along x, y and z.
using Sides = std::uint8_t;
constexpr Sides all_sides = 0x3f;

/// The cell on a side.
std::int64_t beyond(const Mesh& mesh, std::int64_t cell, int side) {
    const std::int64_t stride = mesh.box.stride[at(side / 2)];
    return side % 2 == 1 ? cell + stride : cell - stride;
}

/// A closed cell at a joint.
struct Closed {
    std::int64_t cell;
    Sides shut;               ///< no water comes through these
    std::int32_t number{-1};  ///< in CutBodies::joints, once it has water
};

/// Closed cells with facets, and their sides that bodies fill and facets look at, within 60 degrees.
std::vector<Closed> cells_of_facets(const Mesh& mesh, const ClosedShares& closed, const CutBodies& cut) {
    const double round_off = fluid::grid::share_of_round_off(mesh);
    const auto is_filled = [&](std::int64_t cell, int side) {
        const std::size_t a = at(side / 2), face = at(side % 2 == 1 ? beyond(mesh, cell, side) : cell);
        return std::max(closed.below[a][face], closed.above[a][face]) > 1 - round_off;
    };
    std::vector<Closed> found;
    for (const CutFacet& facet : cut.facets) {
        if (cut.open.volume[at(facet.cell)] != 0) {
            continue;
        }
        Sides ahead = 0;
        for (int a = 0; a < mesh.box.axes; ++a) {
            const double along = facet.area[a] / norm(facet.area);
            const int side = 2 * a + (along > 0 ? 1 : 0);
            if (std::abs(along) > 0.5 && is_filled(facet.cell, side)) {
                ahead = static_cast<Sides>(ahead | 1U << side);
            }
        }
        found.push_back({facet.cell, ahead});
    }
    return found;
}

/// Sorts cells and takes their entries together: shut is what any of them shuts, but for those that shut all.
std::vector<Closed> joined(std::vector<Closed> found) {
    std::sort(found.begin(), found.end(), [](const Closed& f, const Closed& g) { return f.cell < g.cell; });
    std::vector<Closed> all;
    for (const Closed& f : found) {
        if (all.empty() || all.back().cell != f.cell) {
            all.push_back(f);
        } else if (all.back().shut == all_sides || f.shut == all_sides) {
            all.back().shut = std::min(all.back().shut, f.shut);
        } else {
            all.back().shut = static_cast<Sides>(all.back().shut | f.shut);
        }
    }
    return all;
}

/// Closed cells with facets and their closed neighbours, in order.
std::vector<Closed> closed_cells(const Mesh& mesh, const ClosedShares& closed, const CutBodies& cut) {
    std::vector<Closed> found;
    for (const Closed& facet : joined(cells_of_facets(mesh, closed, cut))) {
        found.push_back(facet);
        for (int side = 0; side < 2 * mesh.box.axes; ++side) {
            const std::int64_t beside = beyond(mesh, facet.cell, side);
            if (cut.open.volume[at(beside)] == 0) {
                found.push_back({beside, (facet.shut >> side & 1) != 0 ? all_sides : facet.shut});
            }
        }
    }
    return joined(std::move(found));
}

/// The ways from open cells through closed ones, a cell farther in each round.
class Ways {
 public:
    Ways(const Mesh& mesh, std::vector<Closed> cells, CutBodies& cut)
        : mesh_(&mesh), cells_(std::move(cells)), cut_(&cut) {}

    const Closed* find(std::int64_t cell) const {
        const auto found = std::lower_bound(cells_.begin(), cells_.end(), cell,
                                            [](const Closed& c, std::int64_t wanted) { return c.cell < wanted; });
        return found != cells_.end() && found->cell == cell ? &*found : nullptr;
    }
    /// Goes as far as it comes.
    void go() {
        for (bool is_first = true, is_on = true; is_on || is_first; is_first = false) {
            is_on = go_on(is_first);
        }
    }
    void open_all_sides() {
        for (Closed& c : cells_) {
            c.shut = 0;
        }
    }

 private:
    bool go_on(bool is_first) {
        const std::size_t before = cut_->joints.size();
        std::vector<std::size_t> reached;
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (cells_[i].number >= 0) {
                continue;
            }
            JointCell joint{cells_[i].cell, sources_of(cells_[i], is_first)};
            if (!joint.sources.empty()) {
                cut_->joints.push_back(std::move(joint));
                reached.push_back(i);
            }
        }
        for (std::size_t k = 0; k < reached.size(); ++k) {
            cells_[reached[k]].number = static_cast<std::int32_t>(before + k);
        }
        return !reached.empty();
    }
    std::vector<std::int64_t> sources_of(const Closed& c, bool is_first) const {
        std::vector<std::int64_t> sources;
        for (int side = 0; side < 2 * mesh_->box.axes; ++side) {
            const std::int64_t beside = beyond(*mesh_, c.cell, side);
            if ((c.shut >> side & 1) != 0) {
                continue;
            }
            if (is_first && cut_->open.volume[at(beside)] > 0 && mesh_->box.has_cell(beside)) {
                sources.push_back(beside);
            } else if (const Closed* const known = is_first ? nullptr : find(beside);
                       known != nullptr && known->number >= 0) {
                sources.push_back(-1 - known->number);
            }
        }
        return sources;
    }

    const Mesh* mesh_;
    std::vector<Closed> cells_;
    CutBodies* cut_;
};

}  // namespace

void find_joint_ways(const Mesh& mesh, const ClosedShares& closed, CutBodies& cut) {
    Ways ways(mesh, closed_cells(mesh, closed, cut), cut);
    ways.go();
    const auto lacks_water = [&](const CutFacet& facet) {
        return cut.open.volume[at(facet.cell)] == 0 && ways.find(facet.cell)->number < 0;
    };
    if (std::any_of(cut.facets.begin(), cut.facets.end(), lacks_water)) {
        ways.open_all_sides();
        ways.go();
    }
    for (CutFacet& facet : cut.facets) {
        if (cut.open.volume[at(facet.cell)] == 0) {
            facet.joint = ways.find(facet.cell)->number;
        }
    }
}

}  // namespace riprap::coupling
