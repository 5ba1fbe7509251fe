// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/sph/momentum.hpp"
#include "riprap/fluid/sph/pair_sums.hpp"
#include "riprap/fluid/sph/sph_scratch.hpp"

// From pressures and viscosities to forces on fluid and walls, the same for every scheme.

namespace riprap::fluid {

/// Finds pressure and volume of every particle from its density.
void find_pressure(const SphSettings& settings, const ParticleState& state, WaterFields& water);

/// Makes room for the sums of Momentum and MomentumFromWalls.
void make_room_for_forces(const SphSettings& settings, std::size_t particles, ForceSums& forces);

/// Returns the fields of fluid particles that both sides of a sum of forces read.
inline SweepSide<5 + symmetric_numbers> force_targets(const ParticleState& state, const WaterFields& water) {
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto b = [&](std::size_t k) { return water.correction.view(k); };
    return {
        state.position,
        {v(0), v(1), v(2), water.pressure.view(), water.dynamic_viscosity.view(), b(0), b(1), b(2), b(3), b(4), b(5)}};
}

/// Finds the sums of Momentum: fluid on fluid.
template <class Kernel, class Law>
void add_fluid_forces(const SphSettings& settings, const Kernel& kernel, const ParticleState& state, const Law& law,
                      SphScratchData& s) {
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto p = [&](std::size_t k) { return s.water.correction.times(k, s.water.pressure); };
    const SweepSide<6 + symmetric_numbers> fluid_with_surface{
        state.position,
        {v(0), v(1), v(2), s.water.volume.view(), s.water.dynamic_viscosity.view(), s.water.bareness.view(), p(0), p(1),
         p(2), p(3), p(4), p(5)}};
    const auto f = [&](std::size_t k) { return s.forces.pushes.sink(k); };
    add_pair_sums_within(settings, Momentum<Kernel, Law>{kernel, law}, fluid_with_surface,
                         fresh<7>({f(0), f(1), f(2), s.forces.heat.sink(), f(ForceSums::at_surface),
                                   f(ForceSums::at_surface + 1), f(ForceSums::at_surface + 2)}),
                         s.lists.fluid_fluid);
}

/// Adds the sums of MomentumFromWalls: what walls do to the fluid.
template <class Kernel, class Law>
void add_forces_from_walls(const SphSettings& settings, const Kernel& kernel, const ParticleState& state,
                           const BoundaryParticles& walls, const Law& law, SphScratchData& s) {
    const auto u = [&](std::size_t axis) { return s.walls.mirrored_velocity.view(axis); };
    const SweepSide<9> wall{walls.position,
                            {u(0), u(1), u(2), field(walls.pressure), field(walls.volume), s.walls.grip.view(),
                             component(walls.velocity, 0), component(walls.velocity, 1), component(walls.velocity, 2)}};
    const auto f = [&](std::size_t k) { return s.forces.pushes.sink(k); };
    const std::array<FieldSink, 4> hold = fresh<4>({s.forces.wall_hold.sink(0), s.forces.wall_hold.sink(1),
                                                    s.forces.wall_hold.sink(2), s.forces.wall_hold_power.sink()});
    add_pair_sums(settings, MomentumFromWalls<Kernel, Law>{kernel, law}, force_targets(state, s.water), wall,
                  {f(0), f(1), f(2), s.forces.wall_heat.sink(), hold[0], hold[1], hold[2], hold[3]},
                  s.lists.fluid_walls);
}

/// Finds the sums of WallAverages and PressureOnWalls, for walls that may then be told to move in another way but not
/// to another place.
template <class Kernel>
void sum_at_walls(const SphSettings& settings, const Kernel& kernel, const ParticleState& state,
                  const BoundaryParticles& walls, SphScratchData& s) {
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto b = [&](std::size_t k) { return s.water.correction.view(k); };
    const auto count = walls.position.size();
    WaterAtWallSums& at = s.at_walls;
    at.weight.resize(count, settings.is_plain);
    at.pressure.resize(count, settings.is_plain);
    for (Numbers<3>* sums : {&at.moment, &at.velocity, &at.slope, &at.push}) {
        sums->resize(count, settings.is_plain);
    }
    const WendlandC2 mean(settings.smoothing_length(), settings.domain.dimension);
    add_pair_sums(
        settings, WaterOnWalls<Kernel>{{mean}, {kernel}}, {walls.position, {}},
        {state.position,
         {v(0), v(1), v(2), s.water.pressure.view(), field(state.density), s.water.volume.view(), b(0), b(1), b(2),
          b(3), b(4), b(5)}},
        fresh<14>({at.weight.sink(), at.pressure.sink(), at.moment.sink(0), at.moment.sink(1), at.moment.sink(2),
                   at.velocity.sink(0), at.velocity.sink(1), at.velocity.sink(2), at.slope.sink(0), at.slope.sink(1),
                   at.slope.sink(2), at.push.sink(0), at.push.sink(1), at.push.sink(2)}),
        s.lists.walls_fluid);
}

/// Finds the forces of the fluid on walls [N] from those sums and, where some walls are not slippery, those of
/// ViscosityOnWalls.
template <class Kernel, class Law>
void find_forces_on_walls(const SphSettings& settings, const Kernel& kernel, const ParticleState& state,
                          BoundaryParticles& walls, const Law& law, SphScratchData& s) {
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto u = [&](std::size_t axis) { return s.walls.mirrored_velocity.view(axis); };
    std::vector<Vec3>&p = walls.pressure_force, &t = walls.viscous_force;
    p.resize(walls.position.size());
    make_zero(t, walls.position.size());
    if (std::find(walls.is_slippery.begin(), walls.is_slippery.end(), 0) != walls.is_slippery.end()) {
        add_pair_sums(settings, ViscosityOnWalls<Kernel, Law>{kernel, law},
                      {walls.position, {u(0), u(1), u(2), s.walls.grip.view()}},
                      {state.position, {v(0), v(1), v(2), s.water.volume.view(), s.water.dynamic_viscosity.view()}},
                      {sink_component(t, 0), sink_component(t, 1), sink_component(t, 2)}, s.lists.walls_fluid);
    }
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        p[w] = -walls.volume[w] * (walls.pressure[w] * s.at_walls.slope.vector(w) + s.at_walls.push.vector(w));
        t[w] *= walls.volume[w];
    });
}

}  // namespace riprap::fluid
