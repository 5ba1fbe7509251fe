// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/grid_fluid/carried_water.hpp"

#include <algorithm>

#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/surface.hpp"

namespace riprap::coupling {

using fluid::grid::at;

double mean_across(const fluid::grid::Mesh& mesh, const fluid::Flow& flow, double viscosity, int a,
                   const std::array<int, 3>& face, double time) {
    if (a > 1) {
        return 0;
    }
    const auto psi = [&](int i, int j) {
        return stream_of(flow, {mesh.edge[0][at(i)], mesh.edge[1][at(j)], mesh.centre(2, face[2])}, time, viscosity);
    };
    const auto [i, j, k] = face;
    return a == 0 ? (psi(i, j + 1) - psi(i, j)) / mesh.h(1, j) : -(psi(i + 1, j) - psi(i, j)) / mesh.h(0, i);
}

void set_flow_velocity(const GridFluidSettings& settings, double time, std::array<std::vector<double>, 3>& velocity) {
    const fluid::grid::Mesh& mesh = settings.grid.mesh;
    for (int a = 0; a < 2; ++a) {
        fluid::grid::for_faces(mesh.box, a, [&](std::int64_t f, int i, int j, int k) {
            const int place = a == 0 ? i : j;
            const bool is_high = place == mesh.box.cells[at(a)], is_rim = place == 0 || is_high;
            const bool is_closed =
                is_rim && fluid::grid::is_wall(settings.grid.side[at(2 * a + (is_high ? 1 : 0))].kind);
            velocity[at(a)][at(f)] =
                is_closed ? 0
                          : mean_across(mesh, *settings.scene.flow, settings.kinematic_viscosity, a, {i, j, k}, time);
        });
    }
}

void carry_with_flow(const GridFluidSettings& settings, fluid::grid::GridState& water,
                     fluid::grid::GridScratch& scratch, double dt) {
    set_flow_velocity(settings, water.time + 0.5 * dt, scratch.start.carrier);
    move_water(settings.grid, water, scratch, dt);
    set_flow_velocity(settings, water.time + dt, water.velocity);
}

}  // namespace riprap::coupling
