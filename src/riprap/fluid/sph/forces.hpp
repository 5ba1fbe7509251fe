// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/sph/momentum.hpp"
#include "riprap/fluid/sph/pair_sums.hpp"
#include "riprap/fluid/sph/sph_scratch.hpp"

// From pressures and viscosities to forces on fluid and walls, the same for every scheme.

namespace riprap::fluid {

/// Pressure and volume of every particle, from its density.
void find_pressure(const SphSettings& settings, const ParticleState& state, SphScratchData& scratch);

/// p B of every particle, in place of G.
void find_pressure_tensors(SphScratchData& scratch);

/// Makes room for the sums of Momentum and MomentumFromWalls. They are per volume of the particle until kick.
void make_room_for_forces(std::size_t particles, SphScratchData& scratch);

/// What fluid particles bring to both sides of a sum of forces.
inline SweepSide<5 + symmetric_numbers> force_targets(const ParticleState& state, const SphScratchData& s) {
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto b = [&](std::size_t k) { return tensor_component(s.correction, k); };
    return {state.position,
            {v(0), v(1), v(2), field(s.pressure), field(s.dynamic_viscosity), b(0), b(1), b(2), b(3), b(4), b(5)}};
}

/// Finds the sums of Momentum: fluid on fluid.
template <class Kernel, class Law>
void add_fluid_forces(const SphSettings& settings, const Kernel& kernel, const ParticleState& state, const Law& law,
                      SphScratchData& s) {
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto p = [&](std::size_t k) { return tensor_component(s.pressure_tensor, k); };
    const SweepSide<6 + symmetric_numbers> fluid_with_surface{
        state.position,
        {v(0), v(1), v(2), field(s.volume), field(s.dynamic_viscosity), field(s.bareness), p(0), p(1), p(2), p(3), p(4),
         p(5)}};
    std::vector<Vec3>&f = s.force, &n = s.surface_direction;
    add_pair_sums_within(settings, Momentum<Kernel, Law>{kernel, law}, fluid_with_surface,
                         fresh<7>({sink_component(f, 0), sink_component(f, 1), sink_component(f, 2), sink(s.heat),
                                   sink_component(n, 0), sink_component(n, 1), sink_component(n, 2)}),
                         s.fluid_fluid);
}

/// Adds the sums of MomentumFromWalls: what walls do to the fluid.
template <class Kernel, class Law>
void add_forces_from_walls(const SphSettings& settings, const Kernel& kernel, const ParticleState& state,
                           const BoundaryParticles& walls, const Law& law, SphScratchData& s) {
    const auto u = [&](int axis) { return component(s.mirrored_velocity, axis); };
    const SweepSide<9> wall{walls.position,
                            {u(0), u(1), u(2), field(walls.pressure), field(walls.volume), field(s.grip),
                             component(walls.velocity, 0), component(walls.velocity, 1), component(walls.velocity, 2)}};
    std::vector<Vec3>& f = s.force;
    const std::array<FieldSink, 4> hold = fresh<4>({sink_component(s.wall_hold, 0), sink_component(s.wall_hold, 1),
                                                    sink_component(s.wall_hold, 2), sink(s.wall_hold_power)});
    add_pair_sums(settings, MomentumFromWalls<Kernel, Law>{kernel, law}, force_targets(state, s), wall,
                  {sink_component(f, 0), sink_component(f, 1), sink_component(f, 2), sink(s.wall_heat), hold[0],
                   hold[1], hold[2], hold[3]},
                  s.fluid_walls);
}

/// Finds the sums of WallAverages and PressureOnWalls, for walls that may then be told to move in another way but not
/// to another place.
template <class Kernel>
void sum_at_walls(const SphSettings& settings, const Kernel& kernel, const ParticleState& state,
                  const BoundaryParticles& walls, SphScratchData& s) {
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto b = [&](std::size_t k) { return tensor_component(s.correction, k); };
    const auto count = walls.position.size();
    s.wall_weight.resize(count);
    s.wall_pressure.resize(count);
    for (std::vector<Vec3>* sums : {&s.wall_moment, &s.wall_velocity, &s.wall_slope, &s.wall_push}) {
        sums->resize(count);
    }
    const auto x = [](std::vector<Vec3>& sums, int axis) { return sink_component(sums, axis); };
    const WendlandC2 mean(settings.smoothing_length(), settings.domain.dimension);
    add_pair_sums(settings, WaterOnWalls<Kernel>{{mean}, {kernel}}, {walls.position, {}},
                  {state.position,
                   {v(0), v(1), v(2), field(s.pressure), field(state.density), field(s.volume), b(0), b(1), b(2), b(3),
                    b(4), b(5)}},
                  fresh<14>({sink(s.wall_weight), sink(s.wall_pressure), x(s.wall_moment, 0), x(s.wall_moment, 1),
                             x(s.wall_moment, 2), x(s.wall_velocity, 0), x(s.wall_velocity, 1), x(s.wall_velocity, 2),
                             x(s.wall_slope, 0), x(s.wall_slope, 1), x(s.wall_slope, 2), x(s.wall_push, 0),
                             x(s.wall_push, 1), x(s.wall_push, 2)}),
                  s.walls_fluid);
}

/// What the fluid does to walls [N], from those sums and, where some walls are not slippery, those of ViscosityOnWalls.
template <class Kernel, class Law>
void find_forces_on_walls(const SphSettings& settings, const Kernel& kernel, const ParticleState& state,
                          BoundaryParticles& walls, const Law& law, SphScratchData& s) {
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto u = [&](int axis) { return component(s.mirrored_velocity, axis); };
    std::vector<Vec3>&p = walls.pressure_force, &t = walls.viscous_force;
    p.resize(walls.position.size());
    make_zero(t, walls.position.size());
    if (std::find(walls.is_slippery.begin(), walls.is_slippery.end(), 0) != walls.is_slippery.end()) {
        add_pair_sums(settings, ViscosityOnWalls<Kernel, Law>{kernel, law},
                      {walls.position, {u(0), u(1), u(2), field(s.grip)}},
                      {state.position, {v(0), v(1), v(2), field(s.volume), field(s.dynamic_viscosity)}},
                      {sink_component(t, 0), sink_component(t, 1), sink_component(t, 2)}, s.walls_fluid);
    }
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        p[w] = -walls.volume[w] * (walls.pressure[w] * s.wall_slope[w] + s.wall_push[w]);
        t[w] *= walls.volume[w];
    });
}

}  // namespace riprap::fluid
