// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/wcmps/forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/wcmps/continuity.hpp"
#include "riprap/fluid/wcmps/pair_sums.hpp"

namespace riprap::fluid::wcmps {
namespace {

/// k of MpsMomentum [Pa s/m^2]
double pair_viscosity(const WcmpsSettings& settings) {
    return 2 * settings.rest_density * settings.kinematic_viscosity / settings.lattice().lambda;
}

/// l_0^D D/n_0: from sums to forces [m^D]
double force_factor(const WcmpsSettings& settings) {
    return settings.lattice().first_order() * settings.particle_mass / settings.rest_density;
}

/// Fields of MpsMomentum, which its sums with walls read too.
SweepSide<9> fluid_side(const ParticleState& state, const WcmpsScratchData& s) {
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto n = [&](int axis) { return component(s.normal, axis); };
    return {state.position,
            {v(0), v(1), v(2), field(s.concentration), field(s.pressure_over_concentration), field(s.crowding), n(0),
             n(1), n(2)}};
}

/// tensor a, in the order of sph/symmetric.hpp
Vec3 times(const std::array<double, symmetric_numbers>& t, const Vec3& a) {
    return {t[0] * a.x + t[2] * a.y + t[4] * a.z, t[2] * a.x + t[1] * a.y + t[5] * a.z,
            t[4] * a.x + t[5] * a.y + t[3] * a.z};
}

void average_at_walls(const WcmpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                      WcmpsScratchData& s) {
    const auto count = walls.position.size();
    clear(s.wall_weight, count);
    clear(s.wall_pressure, count);
    for (std::vector<Vec3>* sums : {&s.wall_moment, &s.wall_velocity, &s.wall_slope, &s.wall_push}) {
        clear(*sums, count);
    }
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    clear(s.wall_spread, count);
    const auto at = [](std::vector<Vec3>& sums, int axis) { return sink_component(sums, axis); };
    const auto spread = [&](std::size_t k) {
        return FieldSink{count == 0 ? nullptr : s.wall_spread[0].data() + k, symmetric_numbers};
    };
    add_pair_sums(settings, MpsWallAverages{settings.weight(), settings.rest_density}, {walls.position, {}},
                  {state.position, {v(0), v(1), v(2), field(s.pressure)}},
                  {sink(s.wall_weight), sink(s.wall_pressure), at(s.wall_moment, 0), at(s.wall_moment, 1),
                   at(s.wall_moment, 2), at(s.wall_velocity, 0), at(s.wall_velocity, 1), at(s.wall_velocity, 2)},
                  s.walls_fluid);
    add_pair_sums(
        settings, MpsPressureOnWalls{settings.weight()}, {walls.position, {}},
        {state.position, {field(s.concentration), field(s.pressure_over_concentration)}},
        {at(s.wall_slope, 0), at(s.wall_slope, 1), at(s.wall_slope, 2), at(s.wall_push, 0), at(s.wall_push, 1),
         at(s.wall_push, 2), spread(0), spread(1), spread(2), spread(3), spread(4), spread(5)},
        s.walls_fluid);
    const MpsLattice lattice = settings.lattice();
    s.slope_factor = lattice.first_order();
    s.cell_weight = settings.rest_density / (settings.particle_mass * lattice.number_density);
}

/// Pressure of the fluid at walls, never below zero, for whoever asks, and its velocity mirrored in them [Adami2012,
/// eqs. 22, 23, 27]; h of walls.
void extrapolate_to_walls(const WcmpsSettings& settings, BoundaryParticles& walls, const Vec3& gravity,
                          WcmpsScratchData& s) {
    const auto count = walls.position.size();
    s.wall_head.resize(count);
    s.mirrored_velocity.resize(count);
    s.grip.resize(count);
    walls.pressure.resize(count);
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double weight = s.wall_weight[w];
        const bool is_wet = weight > 0;
        const Vec3 apparent = gravity - walls.acceleration[w];
        const double head = dot(apparent, s.wall_moment[w]);
        s.wall_head[w] = s.wall_mirrors[w] * settings.rest_density * apparent;
        walls.pressure[w] = is_wet ? std::max(0.0, (s.wall_pressure[w] + head) / weight) : 0;
        walls.pressure[w] = s.wall_mirrors[w] == 0 ? s.wall_given[w] : walls.pressure[w];
        s.mirrored_velocity[w] = is_wet ? 2.0 * walls.velocity[w] - s.wall_velocity[w] / weight : walls.velocity[w];
        s.grip[w] = walls.is_slippery[w] != 0 ? 0 : 1;
    });
}

}  // namespace

void begin_forces(const WcmpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                  WcmpsScratchData& s) {
    find_pressure(settings, state, s);
    find_wall_shares(settings, walls, s);
    const auto count = state.position.size();
    for (std::vector<Vec3>* sums : {&s.force, &s.crowding_gradient, &s.wall_hold}) {
        clear(*sums, count);
    }
    for (std::vector<double>* sums : {&s.heat, &s.wall_heat, &s.in_front, &s.wall_hold_power}) {
        clear(*sums, count);
    }
    average_at_walls(settings, state, walls, s);
    const auto at = [](std::vector<Vec3>& sums, int axis) { return sink_component(sums, axis); };
    std::vector<Vec3>&f = s.force, &c = s.crowding_gradient;
    add_pair_sums_within(
        settings, MpsMomentum{settings.weight(), pair_viscosity(settings), settings.spacing}, fluid_side(state, s),
        {at(f, 0), at(f, 1), at(f, 2), sink(s.heat), at(c, 0), at(c, 1), at(c, 2), sink(s.in_front)}, s.fluid_fluid);
}

void load_walls(const WcmpsSettings& settings, const ParticleState& state, BoundaryParticles& walls,
                const Vec3& gravity, WcmpsScratchData& s) {
    extrapolate_to_walls(settings, walls, gravity, s);
    const auto count = walls.position.size();
    clear(walls.viscous_force, count);
    walls.pressure_force.resize(count);
    const auto u = [&](int axis) { return component(s.mirrored_velocity, axis); };
    if (settings.kinematic_viscosity > 0) {
        std::vector<Vec3>& t = walls.viscous_force;
        add_pair_sums(settings, MpsViscosityOnWalls{settings.weight(), pair_viscosity(settings)},
                      {walls.position, {u(0), u(1), u(2), field(s.grip)}},
                      {state.position,
                       {component(state.velocity, 0), component(state.velocity, 1), component(state.velocity, 2)}},
                      {sink_component(t, 0), sink_component(t, 1), sink_component(t, 2)}, s.walls_fluid);
    }
    const double factor = force_factor(settings);
    const bool takes_area = settings.wall_loads == WallLoads::pressure_area && !walls.outward_area.empty();
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double scale = factor * s.wall_share[w];
        if (takes_area) {
            walls.pressure_force[w] = -walls.pressure[w] * walls.outward_area[w];
        } else {
            Vec3 carried = (1 + s.wall_mirrors[w]) * s.wall_push[w] + s.wall_given[w] * s.wall_slope[w];
            carried += times(s.wall_spread[w], s.wall_head[w]);
            walls.pressure_force[w] = scale * carried;
        }
        walls.viscous_force[w] *= scale;
    });
}

void add_walls(const WcmpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
               WcmpsScratchData& s) {
    const auto at = [](std::vector<Vec3>& sums, int axis) { return sink_component(sums, axis); };
    const auto u = [&](int axis) { return component(s.mirrored_velocity, axis); };
    const auto v = [&](int axis) { return component(walls.velocity, axis); };
    const auto h = [&](int axis) { return component(s.wall_head, axis); };
    std::vector<Vec3>&f = s.force, &c = s.crowding_gradient, &hold = s.wall_hold;
    add_pair_sums(settings, MpsMomentumFromWalls{settings.weight(), pair_viscosity(settings), settings.spacing},
                  fluid_side(state, s),
                  {walls.position,
                   {u(0), u(1), u(2), v(0), v(1), v(2), field(s.wall_share), field(s.grip), field(s.wall_mirrors),
                    field(s.wall_given), h(0), h(1), h(2)}},
                  {at(f, 0), at(f, 1), at(f, 2), sink(s.wall_heat), at(c, 0), at(c, 1), at(c, 2), sink(s.in_front),
                   at(hold, 0), at(hold, 1), at(hold, 2), sink(s.wall_hold_power)},
                  s.fluid_walls);
    const double factor = force_factor(settings), gradient = settings.lattice().first_order();
    parallel::for_each(state.size(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        s.force[i] *= factor;
        s.heat[i] = factor * (0.5 * s.heat[i] + s.wall_heat[i]);
        s.crowding_gradient[i] *= gradient;
        s.wall_hold[i] *= factor;
        s.wall_hold_power[i] *= factor;
    });
}

}  // namespace riprap::fluid::wcmps
