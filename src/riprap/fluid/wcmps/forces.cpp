// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps_operators/wall_pairs.hpp"
#include "riprap/fluid/particle/pair_sums.hpp"
#include "riprap/fluid/particle/sweep/zeros.hpp"
#include "riprap/fluid/particle/unsound_particles.hpp"
#include "riprap/fluid/wcmps/momentum_pairs.hpp"
#include "riprap/fluid/wcmps/wcmps.hpp"

namespace riprap::fluid {

namespace {

/// Fields of MpsMomentum, which its sums with walls read too.
auto fluid_side(const ParticleState& state, const WcmpsWater& water, const WcmpsContinuity& continuity) {
    return side(state.position, state.velocity, water.concentration, water.pressure_over_concentration,
                continuity.crowding, continuity.normal);
}

}  // namespace

double Wcmps::pair_viscosity() const {
    return 2 * settings_.rest_density * settings_.kinematic_viscosity / lattice_.lambda;
}

double Wcmps::force_factor() const { return lattice_.first_order() * settings_.particle_mass / settings_.rest_density; }

void Wcmps::average_at_walls(const ParticleState& state, const BoundaryParticles& walls) {
    WcmpsAtWalls& at = at_walls_;
    make_zeros(walls.position.size(), at.weight, at.pressure, at.moment, at.velocity, at.slope, at.push, at.spread);
    add_pair_sums(settings_, MpsWallAverages{weight_, settings_.rest_density}, side(walls.position),
                  side(state.position, state.velocity, water_.pressure),
                  sinks(at.weight, at.pressure, at.moment, at.velocity), lists_.walls_fluid);
    add_pair_sums(settings_, MpsPressureOnWalls{weight_}, side(walls.position),
                  side(state.position, water_.concentration, water_.pressure_over_concentration),
                  sinks(at.slope, at.push, at.spread), lists_.walls_fluid);
    at.slope_factor = lattice_.first_order();
    at.cell_weight = settings_.rest_density / (settings_.particle_mass * lattice_.number_density);
}

void Wcmps::extrapolate_to_walls(BoundaryParticles& walls, const Vec3& gravity) {
    const auto count = walls.position.size();
    walls_.averaged.resize(count);
    walls_.held.resize(count);
    walls_.head.resize(count);
    walls_.mirrored_velocity.resize(count);
    walls_.grip.resize(count);
    walls.pressure.resize(count);
    const std::span<const Vec3> at_face = walls.at_face();
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double weight = at_walls_.weight[w];
        const bool is_wet = weight > 0;
        const Vec3 apparent = gravity - walls.acceleration[w];
        const double head = dot(apparent, at_walls_.moment[w]);
        const bool is_given = walls_.is_given[w] != 0, is_averaged = is_wet && walls_.mirrors[w] == 0 && !is_given;
        walls_.head[w] = walls_.mirrors[w] * settings_.rest_density * apparent;
        walls_.averaged[w] = is_averaged ? at_walls_.pressure[w] / weight : 0;
        walls_.held[w] = is_averaged ? head / weight : is_given ? walls.given_pressure[w] : 0;
        walls.pressure[w] = is_wet ? std::max(0.0, (at_walls_.pressure[w] + head) / weight) : 0;
        walls.pressure[w] = is_given ? walls.given_pressure[w] : walls.pressure[w];
        walls_.mirrored_velocity[w] = is_wet ? 2.0 * at_face[w] - at_walls_.velocity[w] / weight : at_face[w];
        walls_.grip[w] = walls.is_slippery[w] != 0 ? 0 : 1;
    });
}

void Wcmps::begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span,
                         const Vec3& /*gravity*/, ParticleReport& report) {
    find_lost_particle(settings_, state, span.time, report);
    if (!report.problem.empty()) {
        return;
    }
    lists_.place(reach_of(settings_), state.blocks(), state.position, walls.position);
    find_pressure(state);
    damp_sound();
    find_wall_shares(walls);
    stage_.resize(state.position.size(), true, WcmpsForceSums::places);
    forces_ = lend_wcmps_force_sums(stage_);
    average_at_walls(state, walls);
    add_pair_sums_within(settings_, wcmps::MpsMomentum{weight_, pair_viscosity(), settings_.spacing},
                         fluid_side(state, water_, continuity_),
                         fresh(sinks(forces_.force, forces_.heat, forces_.crowding_gradient, forces_.in_front)),
                         lists_.fluid_fluid);
}

void Wcmps::load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) {
    extrapolate_to_walls(walls, in_plane(gravity, settings_.domain));
    make_zeros(walls.position.size(), walls.viscous_force);
    walls.pressure_force.resize(walls.position.size());
    if (settings_.kinematic_viscosity > 0) {
        add_pair_sums(settings_, MpsViscosityOnWalls{weight_, pair_viscosity()},
                      side(walls.position, walls_.mirrored_velocity, walls_.grip), side(state.position, state.velocity),
                      sinks(walls.viscous_force), lists_.walls_fluid);
    }
    const double factor = force_factor();
    const bool takes_area = settings_.wall_loads == WallLoads::pressure_area && !walls.outward_area.empty();
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double scale = factor * walls_.share[w];
        if (takes_area) {
            walls.pressure_force[w] = -walls.pressure[w] * walls.outward_area[w];
        } else {
            Vec3 carried = (1 + walls_.mirrors[w]) * at_walls_.push[w] +
                           (walls_.held[w] + walls_.averaged[w]) * at_walls_.slope[w];
            carried += symmetric_apply(at_walls_.spread[w], walls_.head[w]);
            walls.pressure_force[w] = scale * carried;
        }
        walls.viscous_force[w] *= scale;
    });
}

void Wcmps::add_walls(const ParticleState& state, const BoundaryParticles& walls) {
    add_pair_sums(settings_, wcmps::MpsMomentumFromWalls{weight_, pair_viscosity(), settings_.spacing},
                  fluid_side(state, water_, continuity_),
                  side(walls.position, walls_.mirrored_velocity, walls.velocity, walls_.share, walls_.grip,
                       walls_.mirrors, walls_.held, walls_.averaged, walls_.head),
                  joined(sinks(forces_.force), fresh(sinks(forces_.wall_heat)),
                         sinks(forces_.crowding_gradient, forces_.in_front),
                         fresh(sinks(forces_.wall_hold, forces_.wall_hold_power))),
                  lists_.fluid_walls);
}

}  // namespace riprap::fluid
