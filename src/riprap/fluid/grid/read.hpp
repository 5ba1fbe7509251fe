// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

/// Pressure at a place [Pa]: P between cell centres, linear, plus rho g.x with the density there; that of the nearest
/// cells where the place lies within half a cell of a side.
double read_pressure(const GridSettings& settings, const GridState& state, const Vec3& place);

/// Velocity at a place, linear between faces [m/s].
Vec3 read_velocity(const GridSettings& settings, const GridState& state, const Vec3& place);

/// Kinetic energy of water and air [J] and the first moment of their mass, sum m x [kg m].
struct Energy {
    double kinetic{0};
    Vec3 mass_moment{};

    template <class By>
    static void join(Energy& a, const Energy& b, const By& by) {
        by.add(a.kinetic, b.kinetic);
        by.add(a.mass_moment, b.mass_moment);
    }
};
Energy read_energy(const GridSettings& settings, const GridState& state, const GridScratch& scratch);

}  // namespace riprap::fluid::grid
