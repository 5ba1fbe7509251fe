// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps/mps.hpp"
#include "riprap/fluid/mps/mps_pairs.hpp"
#include "riprap/fluid/mps_operators/collision.hpp"
#include "riprap/fluid/mps_operators/wall_pairs.hpp"
#include "riprap/fluid/particle/pair_sums.hpp"
#include "riprap/fluid/particle/sweep/zeros.hpp"

namespace riprap::fluid {
namespace {

/// Makes s.prediction.share the share over the number of approaching pairs, 0 where there is none; tells whether any is
/// not.
bool find_shares(double share, MpsScratch& s) {
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

void add_collisions(ParticleState& state, const MpsScratch& s) {
    parallel::for_each(state.size(), [&](std::int64_t i) {
        state.velocity[static_cast<std::size_t>(i)] += s.prediction.collision[static_cast<std::size_t>(i)];
    });
}

}  // namespace

void Mps::find_wall_fields(const ParticleState& state, const BoundaryParticles& walls) {
    MpsScratch& s = scratch_;
    const auto count = walls.position.size();
    for (std::vector<double>* values :
         {&s.walls.share, &s.walls.follows, &s.walls.mirrors, &s.walls.given, &s.walls.grip_share}) {
        values->resize(count);
    }
    s.walls.ones.assign(count, 1);
    s.walls.mirrored_velocity.resize(count);
    MpsAtWalls& at = s.at_walls;
    make_zeros(count, at.weight, at.pressure, at.moment, at.velocity, at.slope);
    add_pair_sums(settings_, MpsWallAverages{weight_, settings_.rest_density}, side(walls.position),
                  side(state.position, state.velocity, s.water.pressure),
                  sinks(at.weight, at.pressure, at.moment, at.velocity), s.lists.walls_fluid);
    add_pair_sums(settings_, mps::SlopeAtWalls{weight_}, side(walls.position), side(state.position), sinks(at.slope),
                  s.lists.walls_fluid);
    s.at_walls.slope_factor = lattice_.first_order();
    s.at_walls.cell_weight = settings_.rest_density / (settings_.particle_mass * lattice_.number_density);
    const double per_volume = 1 / std::pow(settings_.spacing, settings_.domain.dimension);
    const bool is_mirrored = settings_.wall_pressure == MpsWallPressure::mirrored;
    const std::span<const Vec3> at_face = walls.at_face();
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const bool is_given = !walls.given_pressure.empty() && walls.given_pressure[w] >= 0;
        s.walls.share[w] = walls.volume[w] * per_volume;
        s.walls.follows[w] = is_given ? 0 : 1;
        s.walls.mirrors[w] = is_mirrored ? s.walls.follows[w] : 0;
        s.walls.given[w] = is_given ? walls.given_pressure[w] : 0;
        s.walls.grip_share[w] = walls.is_slippery[w] != 0 ? 0 : s.walls.share[w];
        s.walls.mirrored_velocity[w] =
            s.at_walls.weight[w] > 0 ? 2.0 * at_face[w] - s.at_walls.velocity[w] / s.at_walls.weight[w] : at_face[w];
    });
}

void Mps::add_viscosity(const ParticleState& state, const BoundaryParticles& walls) {
    MpsScratch& s = scratch_;
    const double volume = settings_.particle_mass / settings_.rest_density;
    const double k = lattice_.second_order() * settings_.rest_density * settings_.kinematic_viscosity * volume;
    const auto water = side(state.position, state.velocity);
    const auto solid = side(walls.position, s.walls.mirrored_velocity, s.walls.grip_share);
    add_pair_sums_within(settings_, mps::Viscosity{weight_, k}, water, sinks(s.prediction.viscous_force),
                         s.lists.fluid_fluid);
    add_pair_sums(settings_, mps::ViscosityFromWalls{weight_, k}, water, solid, sinks(s.prediction.viscous_force),
                  s.lists.fluid_walls);
    add_pair_sums(settings_, MpsViscosityOnWalls{weight_, k}, solid, water, sinks(s.walls.viscous_force),
                  s.lists.walls_fluid);
}

void Mps::predict(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt) {
    MpsScratch& s = scratch_;
    const auto count = state.position.size();
    s.lists.place(reach_of(settings_), state.blocks(), state.position, walls.position);
    s.prediction.start_velocity = state.velocity;
    s.water.pressure.resize(count);
    parallel::for_each(state.size(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        s.water.pressure[i] = pressure_of(settings_, state.density[i]);
    });
    make_zeros(count, s.prediction.viscous_force);
    make_zeros(walls.position.size(), s.walls.viscous_force, s.walls.collision_force);
    find_wall_fields(state, walls);
    if (settings_.kinematic_viscosity > 0) {
        add_viscosity(state, walls);
    }
    parallel::for_each(state.size(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        state.velocity[i] += dt * (s.prediction.viscous_force[i] / settings_.particle_mass + gravity);
    });
}

void Mps::collide(ParticleState& state, const BoundaryParticles& walls, double dt) {
    MpsScratch& s = scratch_;
    const auto count = state.position.size();
    const double contact = std::pow(settings_.collision_distance * settings_.spacing, 2);
    const double tiny = 1e-8 * settings_.spacing * settings_.spacing;
    make_zeros(count, s.prediction.approaching);
    add_pair_sums_within(settings_, mps::Approach{contact}, side(state.position, state.velocity),
                         sinks(s.prediction.approaching), s.lists.fluid_fluid);
    if (find_shares(0.5 * (1 + settings_.collision_ratio), s)) {
        make_zeros(count, s.prediction.collision);
        add_pair_sums_within(settings_, MpsCollision{contact, tiny},
                             side(state.position, state.velocity, s.prediction.share), sinks(s.prediction.collision),
                             s.lists.fluid_fluid);
        add_collisions(state, s);
    }
    make_zeros(count, s.prediction.approaching);
    add_pair_sums(settings_, mps::Approach{contact}, side(state.position, state.velocity),
                  side(walls.position, walls.velocity), sinks(s.prediction.approaching), s.lists.fluid_walls);
    if (find_shares(1 + settings_.collision_ratio, s)) {
        make_zeros(count, s.prediction.collision);
        const mps::CollisionWithWalls pair{contact, tiny};
        const auto fluid = side(state.position, state.velocity, s.prediction.share);
        const auto solid = side(walls.position, walls.velocity, s.walls.ones);
        add_pair_sums(settings_, pair, fluid, solid, sinks(s.prediction.collision), s.lists.fluid_walls);
        add_pair_sums(settings_, pair, solid, fluid, sinks(s.walls.collision_force), s.lists.walls_fluid);
        add_collisions(state, s);
        const double per_time = settings_.particle_mass / dt;
        parallel::for_each(walls.size(),
                           [&](std::int64_t i) { s.walls.collision_force[static_cast<std::size_t>(i)] *= per_time; });
    }
}

}  // namespace riprap::fluid
