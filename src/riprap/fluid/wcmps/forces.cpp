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
    const auto n = [&](int axis) { return component(s.continuity.normal, axis); };
    return {state.position,
            {v(0), v(1), v(2), field(s.water.concentration), field(s.water.pressure_over_concentration),
             field(s.continuity.crowding), n(0), n(1), n(2)}};
}

/// tensor a, in the order of sph/symmetric.hpp
Vec3 times(const std::array<double, symmetric_numbers>& t, const Vec3& a) {
    return {t[0] * a.x + t[2] * a.y + t[4] * a.z, t[2] * a.x + t[1] * a.y + t[5] * a.z,
            t[4] * a.x + t[5] * a.y + t[3] * a.z};
}

void average_at_walls(const WcmpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                      WcmpsScratchData& s) {
    const auto count = walls.position.size();
    clear(s.at_walls.weight, count);
    clear(s.at_walls.pressure, count);
    for (std::vector<Vec3>* sums : {&s.at_walls.moment, &s.at_walls.velocity, &s.at_walls.slope, &s.at_walls.push}) {
        clear(*sums, count);
    }
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    clear(s.at_walls.spread, count);
    const auto at = [](std::vector<Vec3>& sums, int axis) { return sink_component(sums, axis); };
    const auto spread = [&](std::size_t k) {
        return FieldSink{count == 0 ? nullptr : s.at_walls.spread[0].data() + k, symmetric_numbers};
    };
    add_pair_sums(
        settings, MpsWallAverages{settings.weight(), settings.rest_density}, {walls.position, {}},
        {state.position, {v(0), v(1), v(2), field(s.water.pressure)}},
        {sink(s.at_walls.weight), sink(s.at_walls.pressure), at(s.at_walls.moment, 0), at(s.at_walls.moment, 1),
         at(s.at_walls.moment, 2), at(s.at_walls.velocity, 0), at(s.at_walls.velocity, 1), at(s.at_walls.velocity, 2)},
        s.lists.walls_fluid);
    add_pair_sums(settings, MpsPressureOnWalls{settings.weight()}, {walls.position, {}},
                  {state.position, {field(s.water.concentration), field(s.water.pressure_over_concentration)}},
                  {at(s.at_walls.slope, 0), at(s.at_walls.slope, 1), at(s.at_walls.slope, 2), at(s.at_walls.push, 0),
                   at(s.at_walls.push, 1), at(s.at_walls.push, 2), spread(0), spread(1), spread(2), spread(3),
                   spread(4), spread(5)},
                  s.lists.walls_fluid);
    const MpsLattice lattice = settings.lattice();
    s.at_walls.slope_factor = lattice.first_order();
    s.at_walls.cell_weight = settings.rest_density / (settings.particle_mass * lattice.number_density);
}

/// Pressure of the fluid at walls, never below zero, for gauges, and velocity of the fluid mirrored in them [Adami2012,
/// eqs. 22, 23, 27]; A, H and h of walls.
void extrapolate_to_walls(const WcmpsSettings& settings, BoundaryParticles& walls, const Vec3& gravity,
                          WcmpsScratchData& s) {
    const auto count = walls.position.size();
    for (std::vector<double>* values : {&s.walls.averaged, &s.walls.held}) {
        values->resize(count);
    }
    s.walls.head.resize(count);
    s.walls.mirrored_velocity.resize(count);
    s.walls.grip.resize(count);
    walls.pressure.resize(count);
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double weight = s.at_walls.weight[w];
        const bool is_wet = weight > 0;
        const Vec3 apparent = gravity - walls.acceleration[w];
        const double head = dot(apparent, s.at_walls.moment[w]);
        const bool is_given = s.walls.is_given[w] != 0, is_averaged = is_wet && s.walls.mirrors[w] == 0 && !is_given;
        s.walls.head[w] = s.walls.mirrors[w] * settings.rest_density * apparent;
        s.walls.averaged[w] = is_averaged ? s.at_walls.pressure[w] / weight : 0;
        s.walls.held[w] = is_averaged ? head / weight : is_given ? walls.given_pressure[w] : 0;
        walls.pressure[w] = is_wet ? std::max(0.0, (s.at_walls.pressure[w] + head) / weight) : 0;
        walls.pressure[w] = is_given ? walls.given_pressure[w] : walls.pressure[w];
        s.walls.mirrored_velocity[w] =
            is_wet ? 2.0 * walls.velocity[w] - s.at_walls.velocity[w] / weight : walls.velocity[w];
        s.walls.grip[w] = walls.is_slippery[w] != 0 ? 0 : 1;
    });
}

}  // namespace

void begin_forces(const WcmpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                  WcmpsScratchData& s) {
    s.lists.place({settings.support_radius(), settings.domain}, state.position, walls.position);
    find_pressure(settings, state, s.water);
    damp_sound(settings, s.continuity, s.water);
    find_wall_shares(settings, walls, s.walls);
    const auto count = state.position.size();
    for (std::vector<Vec3>* sums : {&s.forces.force, &s.forces.crowding_gradient, &s.forces.wall_hold}) {
        clear(*sums, count);
    }
    for (std::vector<double>* sums :
         {&s.forces.heat, &s.forces.wall_heat, &s.forces.in_front, &s.forces.wall_hold_power}) {
        clear(*sums, count);
    }
    average_at_walls(settings, state, walls, s);
    const auto at = [](std::vector<Vec3>& sums, int axis) { return sink_component(sums, axis); };
    std::vector<Vec3>&f = s.forces.force, &c = s.forces.crowding_gradient;
    add_pair_sums_within(
        settings, MpsMomentum{settings.weight(), pair_viscosity(settings), settings.spacing}, fluid_side(state, s),
        {at(f, 0), at(f, 1), at(f, 2), sink(s.forces.heat), at(c, 0), at(c, 1), at(c, 2), sink(s.forces.in_front)},
        s.lists.fluid_fluid);
}

void load_walls(const WcmpsSettings& settings, const ParticleState& state, BoundaryParticles& walls,
                const Vec3& gravity, WcmpsScratchData& s) {
    extrapolate_to_walls(settings, walls, gravity, s);
    const auto count = walls.position.size();
    clear(walls.viscous_force, count);
    walls.pressure_force.resize(count);
    const auto u = [&](int axis) { return component(s.walls.mirrored_velocity, axis); };
    if (settings.kinematic_viscosity > 0) {
        std::vector<Vec3>& t = walls.viscous_force;
        add_pair_sums(settings, MpsViscosityOnWalls{settings.weight(), pair_viscosity(settings)},
                      {walls.position, {u(0), u(1), u(2), field(s.walls.grip)}},
                      {state.position,
                       {component(state.velocity, 0), component(state.velocity, 1), component(state.velocity, 2)}},
                      {sink_component(t, 0), sink_component(t, 1), sink_component(t, 2)}, s.lists.walls_fluid);
    }
    const double factor = force_factor(settings);
    const bool takes_area = settings.wall_loads == WallLoads::pressure_area && !walls.outward_area.empty();
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double scale = factor * s.walls.share[w];
        if (takes_area) {
            walls.pressure_force[w] = -walls.pressure[w] * walls.outward_area[w];
        } else {
            Vec3 carried = (1 + s.walls.mirrors[w]) * s.at_walls.push[w] +
                           (s.walls.held[w] + s.walls.averaged[w]) * s.at_walls.slope[w];
            carried += times(s.at_walls.spread[w], s.walls.head[w]);
            walls.pressure_force[w] = scale * carried;
        }
        walls.viscous_force[w] *= scale;
    });
}

void add_walls(const WcmpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
               WcmpsScratchData& s) {
    const auto at = [](std::vector<Vec3>& sums, int axis) { return sink_component(sums, axis); };
    const auto u = [&](int axis) { return component(s.walls.mirrored_velocity, axis); };
    const auto v = [&](int axis) { return component(walls.velocity, axis); };
    const auto h = [&](int axis) { return component(s.walls.head, axis); };
    std::vector<Vec3>&f = s.forces.force, &c = s.forces.crowding_gradient, &hold = s.forces.wall_hold;
    add_pair_sums(settings, MpsMomentumFromWalls{settings.weight(), pair_viscosity(settings), settings.spacing},
                  fluid_side(state, s),
                  {walls.position,
                   {u(0), u(1), u(2), v(0), v(1), v(2), field(s.walls.share), field(s.walls.grip),
                    field(s.walls.mirrors), field(s.walls.held), field(s.walls.averaged), h(0), h(1), h(2)}},
                  {at(f, 0), at(f, 1), at(f, 2), sink(s.forces.wall_heat), at(c, 0), at(c, 1), at(c, 2),
                   sink(s.forces.in_front), at(hold, 0), at(hold, 1), at(hold, 2), sink(s.forces.wall_hold_power)},
                  s.lists.fluid_walls);
    const double factor = force_factor(settings), gradient = settings.lattice().first_order();
    parallel::for_each(state.owned(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        s.forces.force[i] *= factor;
        s.forces.heat[i] = factor * (0.5 * s.forces.heat[i] + s.forces.wall_heat[i]);
        s.forces.crowding_gradient[i] *= gradient;
        s.forces.wall_hold[i] *= factor;
        s.forces.wall_hold_power[i] *= factor;
    });
}

}  // namespace riprap::fluid::wcmps
