// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/sph/momentum.hpp"
#include "riprap/fluid/sph/pair_sums.hpp"
#include "riprap/fluid/sph/sph_scratch.hpp"
#include "riprap/fluid/sph/wall_loops.hpp"
#include "riprap/fluid/sph/water_loops.hpp"

// From pressures and viscosities to forces on fluid and walls, the same for every scheme.

namespace riprap::fluid {

/// Finds pressure and volume of every particle from its density.
template <class Where>
void find_pressure(const SphSettings& settings, const ParticleColumns& fluid, WaterFieldsIn<Where>& water) {
    const auto count = static_cast<std::size_t>(fluid.count);
    water.pressure.resize(count, settings.is_plain);
    water.volume.resize(count, settings.is_plain);
    Where::for_each(fluid.count, FindPressure{PressureLaw(settings), settings.particle_mass, fluid.density,
                                              water.pressure.columns(), water.volume.columns()});
}

/// Makes room for the sums of Momentum and MomentumFromWalls.
template <class Where>
void make_room_for_forces(const SphSettings& settings, std::int64_t particles, ForceSumsIn<Where>& forces) {
    const auto count = static_cast<std::size_t>(particles);
    forces.pushes.resize(count, settings.is_plain);
    forces.wall_hold.resize(count, settings.is_plain);
    for (Numbers<1, Where>* numbers : {&forces.heat, &forces.wall_heat, &forces.wall_hold_power}) {
        numbers->resize(count, settings.is_plain);
    }
}

/// Returns the fields of fluid particles that both sides of a sum of forces read.
template <class Where>
SweepSide<5 + symmetric_numbers> force_targets(const ParticleColumns& fluid, const WaterFieldsIn<Where>& water) {
    const auto v = [&](int axis) { return component(fluid.velocities(), axis); };
    const auto b = [&](std::size_t k) { return water.correction.view(k); };
    return {
        fluid.positions(),
        {v(0), v(1), v(2), water.pressure.view(), water.dynamic_viscosity.view(), b(0), b(1), b(2), b(3), b(4), b(5)}};
}

/// Finds the sums of Momentum: fluid on fluid.
template <class Kernel, class Law, class Data>
void add_fluid_forces(const SphSettings& settings, const Kernel& kernel, const ParticleColumns& fluid, const Law& law,
                      Data& s) {
    const auto v = [&](int axis) { return component(fluid.velocities(), axis); };
    const auto p = [&](std::size_t k) { return s.water.correction.times(k, s.water.pressure); };
    const SweepSide<6 + symmetric_numbers> fluid_with_surface{
        fluid.positions(),
        {v(0), v(1), v(2), s.water.volume.view(), s.water.dynamic_viscosity.view(), s.water.bareness.view(), p(0), p(1),
         p(2), p(3), p(4), p(5)}};
    const auto f = [&](std::size_t k) { return s.forces.pushes.sink(k); };
    add_pair_sums_within(settings, Momentum<Kernel, Law>{kernel, law}, fluid_with_surface,
                         fresh<7>({f(0), f(1), f(2), s.forces.heat.sink(), f(PushPlaces::at_surface),
                                   f(PushPlaces::at_surface + 1), f(PushPlaces::at_surface + 2)}),
                         s.lists.fluid_fluid);
}

/// Adds the sums of MomentumFromWalls: what walls do to the fluid.
template <class Kernel, class Law, class Data>
void add_forces_from_walls(const SphSettings& settings, const Kernel& kernel, const ParticleColumns& fluid,
                           const WallColumns& walls, const Law& law, Data& s) {
    const auto u = [&](std::size_t axis) { return s.walls.mirrored_velocity.view(axis); };
    const SweepSide<9> wall{
        walls.positions(),
        {u(0), u(1), u(2), field(walls.pressures()), field(walls.volumes()), s.walls.grip.view(),
         component(walls.velocities(), 0), component(walls.velocities(), 1), component(walls.velocities(), 2)}};
    const auto f = [&](std::size_t k) { return s.forces.pushes.sink(k); };
    const std::array<FieldSink, 4> hold = fresh<4>({s.forces.wall_hold.sink(0), s.forces.wall_hold.sink(1),
                                                    s.forces.wall_hold.sink(2), s.forces.wall_hold_power.sink()});
    add_pair_sums(settings, MomentumFromWalls<Kernel, Law>{kernel, law}, force_targets(fluid, s.water), wall,
                  {f(0), f(1), f(2), s.forces.wall_heat.sink(), hold[0], hold[1], hold[2], hold[3]},
                  s.lists.fluid_walls);
}

/// Finds the sums of WallAverages and PressureOnWalls, for walls that may then be told to move in another way but not
/// to another place.
template <class Kernel, class Data>
void sum_at_walls(const SphSettings& settings, const Kernel& kernel, const ParticleColumns& fluid,
                  const WallColumns& walls, Data& s) {
    const auto v = [&](int axis) { return component(fluid.velocities(), axis); };
    const auto b = [&](std::size_t k) { return s.water.correction.view(k); };
    using Where = typename Data::Where;
    const auto count = static_cast<std::size_t>(walls.count);
    WaterAtWallSumsIn<Where>& at = s.at_walls;
    at.weight.resize(count, settings.is_plain);
    at.pressure.resize(count, settings.is_plain);
    for (Numbers<3, Where>* sums : {&at.moment, &at.velocity, &at.slope, &at.push}) {
        sums->resize(count, settings.is_plain);
    }
    const WendlandC2 mean(settings.smoothing_length(), settings.domain.dimension);
    add_pair_sums(
        settings, WaterOnWalls<Kernel>{{mean}, {kernel}}, {walls.positions(), {}},
        {fluid.positions(),
         {v(0), v(1), v(2), s.water.pressure.view(), field(fluid.densities()), s.water.volume.view(), b(0), b(1), b(2),
          b(3), b(4), b(5)}},
        fresh<14>({at.weight.sink(), at.pressure.sink(), at.moment.sink(0), at.moment.sink(1), at.moment.sink(2),
                   at.velocity.sink(0), at.velocity.sink(1), at.velocity.sink(2), at.slope.sink(0), at.slope.sink(1),
                   at.slope.sink(2), at.push.sink(0), at.push.sink(1), at.push.sink(2)}),
        s.lists.walls_fluid);
}

/// Finds the forces of the fluid on walls [N] from those sums and, where some walls are not slippery, those of
/// ViscosityOnWalls.
template <class Kernel, class Law, class Data>
void find_forces_on_walls(const SphSettings& settings, const Kernel& kernel, const ParticleColumns& fluid,
                          const WallColumns& walls, const Law& law, Data& s) {
    const auto v = [&](int axis) { return component(fluid.velocities(), axis); };
    const auto u = [&](std::size_t axis) { return s.walls.mirrored_velocity.view(axis); };
    using Where = typename Data::Where;
    Where::for_each(walls.count, ClearForce{walls.viscous_force});
    if (walls.may_stick) {
        const std::span<Vec3> t{walls.viscous_force, static_cast<std::size_t>(walls.count)};
        add_pair_sums(settings, ViscosityOnWalls<Kernel, Law>{kernel, law},
                      {walls.positions(), {u(0), u(1), u(2), s.walls.grip.view()}},
                      {fluid.positions(), {v(0), v(1), v(2), s.water.volume.view(), s.water.dynamic_viscosity.view()}},
                      {sink_component(t, 0), sink_component(t, 1), sink_component(t, 2)}, s.lists.walls_fluid);
    }
    Where::for_each(walls.count, ForceOnWall{walls, s.at_walls.slope.columns(), s.at_walls.push.columns()});
}

}  // namespace riprap::fluid
