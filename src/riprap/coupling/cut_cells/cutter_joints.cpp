// SPDX-License-Identifier: Apache-2.0
// Joints between bodies: gaps that are closed for the flow, and where their facets take the water from.
#include <algorithm>

#include "riprap/coupling/cut_cells/cutter.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::CellBox;

/// A gap between two bodies that leaves less than this of a cell or of a face is a joint [-].
constexpr double joint_share = 0.05;

}  // namespace

/// A narrow rest of a cell with bodies on two sides of it.
bool Cutter::is_joint(std::int64_t cell) const {
    const double open = out_.open.volume[at(cell)];
    if (open <= 0 || open >= joint_share) {
        return false;
    }
    const std::int32_t own = touched_[at(cell)];
    if (own == -2) {
        return true;
    }
    for (int a = 0; a < mesh_->box.axes; ++a) {
        const std::int64_t t = mesh_->box.stride[at(a)];
        const auto other = [&](std::int64_t beyond) {
            return touched_[at(beyond)] != -1 && touched_[at(beyond)] != own;
        };
        if ((below_[at(a)][at(cell)] > 0.5 && other(cell - t)) ||
            (above_[at(a)][at(cell + t)] > 0.5 && other(cell + t))) {
            return true;
        }
    }
    return false;
}

/// A narrow rest of the face below a cell with two bodies in the cells on its sides. All that bodies displace on one
/// side of it might have to come through, at any speed.
bool Cutter::is_narrow(int a, std::int64_t cell) const {
    const double open = out_.open.area[at(a)][at(cell)];
    if (open <= 0 || open >= joint_share) {
        return false;
    }
    const std::int32_t below = touched_[at(cell - mesh_->box.stride[at(a)])], above = touched_[at(cell)];
    return below == -2 || above == -2 || (below != -1 && above != -1 && below != above);
}

void Cutter::close_joints() {
    std::vector<std::int64_t> joints;
    std::vector<std::pair<int, std::int64_t>> narrow;
    for (const CutFacet& facet : out_.facets) {
        if (is_joint(facet.cell)) {
            joints.push_back(facet.cell);
        }
        for (int a = 0; a < mesh_->box.axes; ++a) {
            for (const std::int64_t face : {facet.cell, facet.cell + mesh_->box.stride[at(a)]}) {
                if (is_narrow(a, face)) {
                    narrow.emplace_back(a, face);
                }
            }
        }
    }
    for (const auto& [a, face] : narrow) {
        out_.open.area[at(a)][at(face)] = 0;
    }
    for (const std::int64_t cell : joints) {
        out_.open.volume[at(cell)] = 0;
        for (int a = 0; a < mesh_->box.axes; ++a) {
            out_.open.area[at(a)][at(cell)] = out_.open.area[at(a)][at(cell + mesh_->box.stride[at(a)])] = 0;
        }
    }
}

/// Finds the water for closed cells with facets: from the nearest open cells, through closed cells beside them.
void Cutter::find_joints() {
    const CellBox& box = mesh_->box;
    const auto for_neighbours = [&](std::int64_t cell, const auto& f) {
        for (int a = 0; a < box.axes; ++a) {
            f(cell - box.stride[at(a)]);
            f(cell + box.stride[at(a)]);
        }
    };
    std::vector<std::int64_t> cells;
    for (const CutFacet& facet : out_.facets) {
        if (out_.open.volume[at(facet.cell)] == 0) {
            cells.push_back(facet.cell);
            for_neighbours(facet.cell, [&](std::int64_t beside) {
                if (out_.open.volume[at(beside)] == 0) {
                    cells.push_back(beside);
                }
            });
        }
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    constexpr std::int32_t unknown = -1;
    std::vector<std::int32_t> number(cells.size(), unknown);
    const auto place_of = [&](std::int64_t cell) {
        const auto found = std::lower_bound(cells.begin(), cells.end(), cell);
        return found != cells.end() && *found == cell ? found - cells.begin() : std::ptrdiff_t{-1};
    };
    for (bool is_first = true;; is_first = false) {
        const std::size_t before = out_.joints.size();
        std::vector<std::size_t> reached;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (number[i] != unknown) {
                continue;
            }
            JointCell joint{cells[i], {}};
            for_neighbours(cells[i], [&](std::int64_t beside) {
                const std::ptrdiff_t known = place_of(beside);
                if (is_first && out_.open.volume[at(beside)] > 0 && box.has_cell(beside)) {
                    joint.sources.push_back(beside);
                } else if (!is_first && known >= 0 && number[at(known)] != unknown) {
                    joint.sources.push_back(-1 - number[at(known)]);
                }
            });
            if (!joint.sources.empty()) {
                out_.joints.push_back(std::move(joint));
                reached.push_back(i);
            }
        }
        for (std::size_t k = 0; k < reached.size(); ++k) {
            number[reached[k]] = static_cast<std::int32_t>(before + k);
        }
        if (reached.empty()) {
            break;
        }
    }
    for (CutFacet& facet : out_.facets) {
        if (out_.open.volume[at(facet.cell)] == 0) {
            facet.joint = number[at(place_of(facet.cell))];
        }
    }
}

}  // namespace riprap::coupling
