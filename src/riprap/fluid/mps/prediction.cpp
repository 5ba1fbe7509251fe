// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/prediction.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps/mps_pairs.hpp"
#include "riprap/fluid/wcmps/pair_sums.hpp"

namespace riprap::fluid::mps {
namespace {

std::array<FieldView, 3> fields_of(const std::vector<Vec3>& v) {
    return {component(v, 0), component(v, 1), component(v, 2)};
}
std::array<FieldSink, 3> sinks_of(std::vector<Vec3>& v) {
    return {sink_component(v, 0), sink_component(v, 1), sink_component(v, 2)};
}

/// b, m, P, who follows the water, and the velocity of the fluid mirrored in walls [Adami2012, eq. 23]; the water about
/// them, with the pressure of the last solve.
void describe_walls(const MpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                    MpsScratchData& s) {
    const auto count = walls.position.size();
    for (std::vector<double>* values :
         {&s.walls.share, &s.walls.follows, &s.walls.mirrors, &s.walls.given, &s.walls.grip_share}) {
        values->resize(count);
    }
    s.walls.ones.assign(count, 1);
    s.walls.mirrored_velocity.resize(count);
    clear(s.at_walls.weight, count);
    clear(s.at_walls.pressure, count);
    clear(s.at_walls.moment, count);
    clear(s.at_walls.velocity, count);
    const auto v = fields_of(state.velocity);
    const auto m = sinks_of(s.at_walls.moment), u = sinks_of(s.at_walls.velocity);
    add_pair_sums(settings, wcmps::MpsWallAverages{settings.weight(), settings.rest_density}, {walls.position, {}},
                  {state.position, {v[0], v[1], v[2], field(s.water.pressure)}},
                  {sink(s.at_walls.weight), sink(s.at_walls.pressure), m[0], m[1], m[2], u[0], u[1], u[2]},
                  s.lists.walls_fluid);
    clear(s.at_walls.slope, count);
    add_pair_sums(settings, SlopeAtWalls{settings.weight()}, {walls.position, {}}, {state.position, {}},
                  sinks_of(s.at_walls.slope), s.lists.walls_fluid);
    const MpsLattice lattice = settings.lattice();
    s.at_walls.slope_factor = lattice.first_order();
    s.at_walls.cell_weight = settings.rest_density / (settings.particle_mass * lattice.number_density);
    const double per_volume = 1 / std::pow(settings.spacing, settings.domain.dimension);
    const bool is_mirrored = settings.wall_pressure == MpsWallPressure::mirrored;
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const bool is_given = !walls.given_pressure.empty() && walls.given_pressure[w] >= 0;
        s.walls.share[w] = walls.volume[w] * per_volume;
        s.walls.follows[w] = is_given ? 0 : 1;
        s.walls.mirrors[w] = is_mirrored ? s.walls.follows[w] : 0;
        s.walls.given[w] = is_given ? walls.given_pressure[w] : 0;
        s.walls.grip_share[w] = walls.is_slippery[w] != 0 ? 0 : s.walls.share[w];
        s.walls.mirrored_velocity[w] = s.at_walls.weight[w] > 0
                                           ? 2.0 * walls.velocity[w] - s.at_walls.velocity[w] / s.at_walls.weight[w]
                                           : walls.velocity[w];
    });
}

/// Viscous forces on particles and walls [N].
void add_viscosity(const MpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                   MpsScratchData& s) {
    const MpsLattice lattice = settings.lattice();
    const double volume = settings.particle_mass / settings.rest_density;
    const double k = lattice.second_order() * settings.rest_density * settings.kinematic_viscosity * volume;
    const auto v = fields_of(state.velocity), u = fields_of(s.walls.mirrored_velocity);
    const auto f = sinks_of(s.prediction.viscous_force), t = sinks_of(s.walls.viscous_force);
    add_pair_sums_within(settings, Viscosity{settings.weight(), k}, {state.position, v}, f, s.lists.fluid_fluid);
    add_pair_sums(settings, ViscosityFromWalls{settings.weight(), k}, {state.position, v},
                  {walls.position, {u[0], u[1], u[2], field(s.walls.grip_share)}}, f, s.lists.fluid_walls);
    add_pair_sums(settings, wcmps::MpsViscosityOnWalls{settings.weight(), k},
                  {walls.position, {u[0], u[1], u[2], field(s.walls.grip_share)}}, {state.position, v}, t,
                  s.lists.walls_fluid);
}

/// Makes s.prediction.share the share over the number of approaching pairs, 0 where there is none; tells whether any is
/// not.
bool find_shares(double share, MpsScratchData& s) {
    s.prediction.share.resize(s.prediction.approaching.size());
    const double most = parallel::reduce(
        static_cast<std::int64_t>(s.prediction.share.size()), 0.0,
        [&](std::int64_t entry) {
            const auto i = static_cast<std::size_t>(entry);
            s.prediction.share[i] = s.prediction.approaching[i] > 0.5 ? share / s.prediction.approaching[i] : 0;
            return s.prediction.share[i];
        },
        [](double a, double b) { return std::max(a, b); });
    return most > 0;
}

void add_collisions(ParticleState& state, const MpsScratchData& s) {
    parallel::for_each(state.size(), [&](std::int64_t i) {
        state.velocity[static_cast<std::size_t>(i)] += s.prediction.collision[static_cast<std::size_t>(i)];
    });
}

}  // namespace

void predict(const MpsSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
             double dt, MpsScratchData& s) {
    const auto count = state.position.size();
    s.lists.place({settings.support_radius(), settings.domain}, state.position, walls.position);
    s.prediction.start_velocity = state.velocity;
    s.water.pressure.resize(count);
    parallel::for_each(state.size(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        s.water.pressure[i] = pressure_of(settings, state.density[i]);
    });
    clear(s.prediction.viscous_force, count);
    clear(s.walls.viscous_force, walls.position.size());
    clear(s.walls.collision_force, walls.position.size());
    describe_walls(settings, state, walls, s);
    if (settings.kinematic_viscosity > 0) {
        add_viscosity(settings, state, walls, s);
    }
    parallel::for_each(state.size(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        state.velocity[i] += dt * (s.prediction.viscous_force[i] / settings.particle_mass + gravity);
    });
}

void collide(const MpsSettings& settings, ParticleState& state, const BoundaryParticles& walls, double dt,
             MpsScratchData& s) {
    const auto count = state.position.size();
    const double contact = std::pow(settings.collision_distance * settings.spacing, 2);
    const double tiny = 1e-8 * settings.spacing * settings.spacing;
    const auto v = fields_of(state.velocity);
    clear(s.prediction.approaching, count);
    add_pair_sums_within(settings, Approach{contact}, {state.position, v}, {sink(s.prediction.approaching)},
                         s.lists.fluid_fluid);
    if (find_shares(0.5 * (1 + settings.collision_ratio), s)) {
        clear(s.prediction.collision, count);
        add_pair_sums_within(settings, wcmps::MpsCollision{contact, tiny},
                             {state.position, {v[0], v[1], v[2], field(s.prediction.share)}},
                             sinks_of(s.prediction.collision), s.lists.fluid_fluid);
        add_collisions(state, s);
    }
    const auto w = fields_of(walls.velocity);
    clear(s.prediction.approaching, count);
    add_pair_sums(settings, Approach{contact}, {state.position, v}, {walls.position, w},
                  {sink(s.prediction.approaching)}, s.lists.fluid_walls);
    if (find_shares(1 + settings.collision_ratio, s)) {
        clear(s.prediction.collision, count);
        const SweepSide<4> fluid{state.position, {v[0], v[1], v[2], field(s.prediction.share)}};
        const SweepSide<4> solid{walls.position, {w[0], w[1], w[2], field(s.walls.ones)}};
        add_pair_sums(settings, CollisionWithWalls{contact, tiny}, fluid, solid, sinks_of(s.prediction.collision),
                      s.lists.fluid_walls);
        add_pair_sums(settings, CollisionWithWalls{contact, tiny}, solid, fluid, sinks_of(s.walls.collision_force),
                      s.lists.walls_fluid);
        add_collisions(state, s);
        const double per_time = settings.particle_mass / dt;
        parallel::for_each(walls.size(),
                           [&](std::int64_t i) { s.walls.collision_force[static_cast<std::size_t>(i)] *= per_time; });
    }
}

}  // namespace riprap::fluid::mps
