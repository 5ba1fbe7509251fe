// SPDX-License-Identifier: Apache-2.0
// Bodies that leave the domain where the water has a wall.
#include <fmt/format.h>

#include <algorithm>

#include "riprap/body/may_move.hpp"
#include "riprap/coupling/cut_cells/side_facets.hpp"
#include "riprap/coupling/grid_fluid/grid_parts.hpp"
#include "riprap/fluid/grid/boundary.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;

/// Tells whether water, and not air, lies at the surface of a body.
bool is_wetted(const GridFluid::Scratch& scratch, const fluid::grid::GridState& water, std::size_t body) {
    return std::ranges::any_of(scratch.cut.facets, [&](const CutFacet& facet) {
        return at(facet.body) == body && moves_fluid(facet) && water.fraction[at(facet.cell)] > 0.5;
    });
}

/// Low or high side of the mesh, a wall of the water, that the way from one place to another goes out through; -1:
/// none.
int side_passed(const fluid::grid::GridSettings& grid, const Vec3& from, const Vec3& to) {
    for (int side = 0; side < 2 * grid.mesh.box.axes; ++side) {
        const int a = side / 2;
        const auto& edge = grid.mesh.edge[at(a)];
        const double place = side % 2 == 0 ? edge.front() : edge.back(), out = side % 2 == 0 ? -1 : 1;
        const fluid::grid::Side& wall = grid.side[at(side)];
        if (is_wall(wall.kind) && !wall.is_for_air && out * (from[a] - place) <= 0 && out * (to[a] - place) > 0) {
            return side;
        }
    }
    return -1;
}

}  // namespace

Outcome leaving_outcome(const FluidScene& scene, const GridFluidSettings& settings, const GridFluid::Scratch& scratch,
                        const GridFluidFields& fields, const body::Motion& middle, double time) {
    for (std::size_t b = 0; b < fields.cut_position.size(); ++b) {
        if (!body::may_move(scene.bodies, b) || settings.is_dry(b)) {
            continue;
        }
        const int side = side_passed(settings.grid, fields.cut_position[b], middle.pose[b].position);
        if (side >= 0 && is_wetted(scratch, fields.water, b)) {
            const bool is_low = side % 2 == 0;
            return {
                fmt::format("'{}' leaves the water through the {} side of {} of the domain at t = {:.6g} s, a wall for "
                            "the water alone",
                            scene.bodies.name(BodyId{static_cast<std::int32_t>(b)}), is_low ? "low" : "high",
                            "xyz"[side / 2], time),
                0,
                fmt::format("a [[body]] with fixed = true along that side holds it; fluid.domain.{} farther out makes "
                            "room for all of its way",
                            is_low ? "low" : "high")};
        }
    }
    return {};
}

}  // namespace riprap::coupling
