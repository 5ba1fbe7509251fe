// SPDX-License-Identifier: Apache-2.0
// Joints between bodies: gaps that are closed for the flow, and where their facets take the water from.
#include <algorithm>
#include <cmath>

#include "riprap/coupling/cut_cells/cutter.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::CellBox;

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

/// Whether a body holds a place, as far as its cell tells.
bool Cutter::holds(std::int32_t body, const Vec3& x) const {
    const std::int64_t cell = mesh_->box.index(mesh_->cell_at(0, x.x), mesh_->cell_at(1, x.y), mesh_->cell_at(2, x.z));
    const std::span<const PartInCell> parts = parts_in(cell);
    return fills(body, cell) || std::any_of(parts.begin(), parts.end(), [&](const PartInCell& part) {
               const auto first = part_planes_.begin() + part.first;
               return part.body == body && std::all_of(first, first + part.count, [&](const geometry::Plane& plane) {
                          return dot(plane.normal, x) < plane.offset;
                      });
           });
}

/// Drops facets that lie deep in another body: water beside a wall that goes through a floor does not reach what of the
/// wall is in the floor. At a joint, a body comes out of the other one within half a cell along the facet's own normal.
void Cutter::drop_covered_facets() {
    std::vector<std::int32_t> others;
    std::erase_if(out_.facets, [&](const CutFacet& facet) {
        const std::int32_t touched = touched_[at(facet.cell)];
        if (touched == -1 || touched == facet.body) {
            return false;
        }
        others.assign(1, filled_[at(facet.cell)]);
        for (const PartInCell& part : parts_in(facet.cell)) {
            others.push_back(part.body);
        }
        const Vec3 x = facet.place(), n = facet.area / norm(facet.area);
        double half = 0;
        for (int a = 0; a < mesh_->box.axes; ++a) {
            half += 0.5 * std::abs(n[a]) * mesh_->h(a, mesh_->cell_at(a, x[a]));
        }
        return std::any_of(others.begin(), others.end(), [&](std::int32_t other) {
            return other >= 0 && other != facet.body && holds(other, x - half * n) &&
                   holds(other, x + (1e-6 * half) * n);
        });
    });
}

}  // namespace riprap::coupling
