// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/grid_step.hpp"
#include "riprap/fluid/grid/momentum.hpp"
#include "riprap/fluid/grid/porous.hpp"
#include "riprap/fluid/grid/pressure.hpp"
#include "riprap/fluid/grid/surface.hpp"

namespace riprap::fluid::grid {

/// A box of equal cells with its low corner at the origin; one cell along z is a plane flow.
inline GridSettings tank(const Vec3& size, const std::array<int, 3>& cells) {
    GridSettings settings;
    settings.mesh = Mesh(
        {uniform_edges(0, size.x, cells[0]), uniform_edges(0, size.y, cells[1]), uniform_edges(0, size.z, cells[2])},
        cells[2] > 1 ? 3 : 2);
    return settings;
}

inline double largest_speed(const GridSettings& settings, const GridState& state) {
    double largest = 0;
    for (int a = 0; a < settings.mesh.box.axes; ++a) {
        for_faces(settings.mesh.box, a, [&](std::int64_t f, int, int, int) {
            largest = std::max(largest, std::abs(state.velocity[at(a)][at(f)]));
        });
    }
    return largest;
}

}  // namespace riprap::fluid::grid
