// SPDX-License-Identifier: Apache-2.0
// Joints between bodies: gaps that are closed for the flow, and where their facets take the water from.
#include <algorithm>
#include <cmath>

#include "riprap/coupling/cut_cells/cutter.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;

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
