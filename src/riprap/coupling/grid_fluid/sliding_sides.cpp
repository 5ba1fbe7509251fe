// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/grid_fluid/sliding_sides.hpp"

#include "riprap/fluid/grid/boundary.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;

/// Shear that a side exerts on the water of a cell beside it along an axis [Pa]: the mean of both faces of the cell.
double shear_on(const fluid::grid::GridSettings& settings, const fluid::grid::GridScratch& s, int side, int along,
                const std::array<int, 3>& place) {
    const auto& box = settings.mesh.box;
    const int a = side / 2;
    const std::int64_t cell = box.index(place[0], place[1], place[2]);
    const std::int64_t beyond = (side % 2 == 1 ? 1 : -1) * box.stride[at(a)], next = box.stride[at(along)];
    const auto& u = s.start.carrier[at(along)];
    const double difference =
        0.5 * (u[at(cell + beyond)] - u[at(cell)] + u[at(cell + next + beyond)] - u[at(cell + next)]);
    return s.stress.viscosity[at(cell)] * difference / settings.mesh.h(a, place[at(a)]);
}

}  // namespace

double power_of_sliding_sides(const fluid::grid::GridSettings& settings, const fluid::grid::GridScratch& s) {
    const auto& box = settings.mesh.box;
    double power = 0;
    for (int side = 0; side < 2 * box.axes; ++side) {
        const Vec3& wall = settings.side[at(side)].velocity;
        const int a = side / 2;
        if (norm(wall) == 0 || !fluid::grid::is_wall(settings.side[at(side)].kind)) {
            continue;
        }
        const int layer = side % 2 == 1 ? box.cells[at(a)] - 1 : 0;
        power += fluid::grid::sum_cells(box, [&](std::int64_t cell, int i, int j, int k) {
            const std::array<int, 3> place{i, j, k};
            if (place[at(a)] != layer) {
                return 0.0;
            }
            double sum = 0;
            for (int along = 0; along < box.axes; ++along) {
                sum += wall[along] != 0 ? wall[along] * shear_on(settings, s, side, along, place) : 0;
            }
            return sum * s.room.area[at(a)][at(side % 2 == 1 ? cell + box.stride[at(a)] : cell)];
        });
    }
    return power;
}

}  // namespace riprap::coupling
