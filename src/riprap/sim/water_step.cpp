// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/water_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/near_samples.hpp"
#include "riprap/fluid/sph/kick.hpp"

namespace riprap::sim {

namespace {

/// How a driven body speeds up over the step: where its velocity jumps, the jump is spread over the step and no more.
coupling::Acceleration driven_acceleration(const body::BodySet& bodies, std::size_t b, double time, double dt) {
    const BodyId body{static_cast<std::int32_t>(b)};
    const double moment = 0.5 * dt;
    const body::DrivenState before = driven_state(bodies, body, time - moment);
    const body::DrivenState after = driven_state(bodies, body, time + moment);
    return {(after.velocity - before.velocity) / (2 * moment),
            (after.angular_velocity - before.angular_velocity) / (2 * moment)};
}

/// The motion of all bodies with poses and velocities of `bodies`, `ahead` seconds of acceleration later. Driven bodies
/// speed up as their motion says and by their `correction`, where there are any [m/s^2].
void fill_motion(const Model& model, const body::BodyState& bodies, const body::BodyKinematics& kinematics,
                 const std::vector<coupling::Acceleration>& acceleration, std::span<const Vec3> correction, double time,
                 double ahead, double dt, coupling::BodyMotion& motion) {
    const auto count = at(model.bodies.size());
    motion.pose.resize(count);
    motion.velocity.resize(count);
    motion.angular_velocity.resize(count);
    motion.acceleration.resize(count);
    motion.angular_acceleration.resize(count);
    for (std::size_t b = 0; b < count; ++b) {
        coupling::Acceleration a;
        const bool is_free = kinematics.inverse_mass[b] > 0;
        if (is_free) {
            a = acceleration[b];
        } else if (model.bodies.drive[b] == body::Drive::driven) {
            a = driven_acceleration(model.bodies, b, time, dt);
            a.linear += correction.empty() ? Vec3{} : correction[b];
        }
        const double later = is_free ? ahead : 0;
        motion.pose[b] = {bodies.position[b], bodies.orientation[b]};
        motion.velocity[b] = bodies.velocity[b] + later * a.linear;
        motion.angular_velocity[b] = kinematics.angular_velocity[b] + later * a.angular;
        motion.acceleration[b] = a.linear;
        motion.angular_acceleration[b] = a.angular;
    }
}

/// Boundary particles of bodies that move as scratch.motion says, `ahead` seconds after the State, and behind openings.
void place_walls(const Model& model, const State& state, double ahead, WaterScratch& scratch) {
    const FluidModel& water = *model.fluid;
    place_samples(samples_near_water(model, scratch), scratch.motion, scratch.walls, scratch.is_still);
    if (!water.open.empty()) {
        place_openings(water.open, state.open, water.sph, state.time + ahead, ahead, scratch.walls);
    }
}

/// What stays the same over a run: who never moves, and the share of a body's mass that its wall treatment feeds back:
/// twice the water that its first layer would hold, as pressure is carried over about two spacings into the wall.
void describe_bodies(const Model& model, WaterScratch& scratch) {
    const body::BodySet& bodies = model.bodies;
    const fluid::SphSettings& sph = model.fluid->sph;
    scratch.kappa.assign(at(bodies.size()), 0);
    scratch.is_still.resize(at(bodies.size()));
    scratch.is_loose.resize(at(bodies.size()));
    for (std::size_t b = 0; b < scratch.is_still.size(); ++b) {
        const bool is_released = std::isfinite(bodies.release_time[b]);
        scratch.is_still[b] = bodies.drive[b] == body::Drive::fixed && !is_released ? 1 : 0;
        scratch.is_loose[b] = bodies.drive[b] == body::Drive::free || is_released ? 1 : 0;
    }
    scratch.inertia.resize(at(bodies.size()));
    const coupling::SampleSet& samples = model.fluid->samples;
    for (std::size_t i = 0; i < samples.body.size(); ++i) {
        const auto b = at(samples.body[i].value);
        if (samples.depth[i] < sph.spacing && bodies.mass[b] > 0) {
            scratch.kappa[b] += 2 * sph.rest_density * samples.volume[i] / bodies.mass[b];
        }
    }
    // The guard is not iterated: its springs on one body must not swing it faster than its particles.
    scratch.guard_share.resize(at(bodies.size()));
    for (std::size_t b = 0; b < scratch.guard_share.size(); ++b) {
        scratch.guard_share[b] = scratch.is_loose[b] != 0 ? 1 / std::max(1.0, scratch.kappa[b]) : 1.0;
    }
    for (std::size_t b = 0; b < scratch.inertia.size(); ++b) {
        const Vec3& moments = bodies.principal_moments[b];
        scratch.inertia[b] = bodies.is_planar ? moments.z : (moments.x + moments.y + moments.z) / 3;
    }
}

/// What bodies do under the loads found: those of the water plus what else made them speed up in the last step.
coupling::Acceleration response(const State& state, const WaterScratch& scratch, std::size_t b) {
    return {scratch.kinematics.inverse_mass[b] * scratch.force[b] + state.coupling.dry_acceleration[b],
            scratch.kinematics.inverse_inertia[b] * scratch.torque[b] + state.coupling.dry_angular_acceleration[b]};
}

/// A body that moves and has boundary particles among the layers of an opening, in words; empty where there is none.
/// Bodies that stay are looked at when the case is read.
std::string find_intruder(const Model& model, const WaterScratch& scratch) {
    const FluidModel& water = *model.fluid;
    for (std::size_t i = 0; !water.open.empty() && i < scratch.near_numbers.size(); ++i) {
        const BodyId body = water.samples.body[at(scratch.near_numbers[i])];  // all those of bodies that move are near
        if (scratch.is_still[at(body.value)] != 0) {
            continue;
        }
        const fluid::Opening* const opening = opening_with_layers_at(water.open, water.sph, scratch.walls.position[i]);
        if (opening != nullptr) {
            return fmt::format("'{}' stands behind the opening '{}', among the layers of its water",
                               model.bodies.name(body), opening->name);
        }
    }
    return {};
}

Vec3 in_plane_force(const Model& model, const Vec3& f) { return model.bodies.is_planar ? Vec3{f.x, f.y, 0} : f; }

/// Loads on bodies that speed up as `guess` says.
void load_bodies(const Model& model, const State& state, WaterScratch& scratch,
                 const std::vector<coupling::Acceleration>& guess, double dt) {
    const double middle = state.time + 0.5 * dt;
    fill_motion(model, scratch.middle, scratch.kinematics, guess, scratch.correction, middle, 0.5 * dt, dt,
                scratch.motion);
    place_walls(model, state, 0.5 * dt, scratch);
    const FluidModel& water = *model.fluid;
    const bool is_penalty = water.wall == WallTreatment::penalty;
    if (is_penalty) {
        scratch.penalty.push(model.shapes, model.bodies, scratch.motion, water.is_dry,
                             coupling::penalty_settings(water.sph), {}, state.fluid, scratch.extra_force,
                             scratch.loads);
    }
    load_walls(water.sph, state.fluid, scratch.walls, model.gravity.at(middle), scratch.sph);
    if (!is_penalty) {
        gather_loads(samples_near_water(model, scratch), scratch.motion, scratch.walls, scratch.loads);
        for (std::size_t b = 0; b < scratch.held_loads.pressure_force.size(); ++b) {
            scratch.loads.pressure_force[b] += scratch.held_loads.pressure_force[b];
            scratch.loads.pressure_torque[b] += scratch.held_loads.pressure_torque[b];
        }
    }
    const auto count = at(model.bodies.size());
    scratch.force.resize(count);
    scratch.torque.resize(count);
    for (std::size_t b = 0; b < count; ++b) {
        scratch.force[b] = in_plane_force(model, scratch.loads.pressure_force[b] + scratch.loads.viscous_force[b]);
        scratch.torque[b] = scratch.loads.pressure_torque[b] + scratch.loads.viscous_torque[b];
    }
}

/// Everywhere that water may enter less than a spacing past, and faces that may make joints.
std::vector<Vec3> places_of_openings_and_joints(const Model& model, const WaterScratch& scratch) {
    const FluidModel& water = *model.fluid;
    std::vector<Vec3> places;
    for (const fluid::Inflow& inflow : water.open.inflows) {
        for (const Vec3& row : inflow.rows) {
            places.push_back(row);
            places.push_back(row + water.sph.spacing * inflow.opening.direction());
        }
    }
    add_places_of_joints(model, scratch.is_loose, scratch.motion, places);
    return places;
}

/// Keeps scratch.near_numbers those of the samples that the water may feel in this step. They are found anew when it
/// may have come farther than the margin that was left the last time, which follows from the State alone.
void find_near_samples(const Model& model, State& state, WaterScratch& scratch, double dt) {
    const FluidModel& water = *model.fluid;
    if (water.samples.size() == 0) {
        return;
    }
    CouplingState& coupling = state.coupling;
    const double margin = 2 * water.sph.spacing;
    const double fastest = parallel::reduce(
        state.fluid.size(), 0.0, [&](std::int64_t i) { return norm_squared(state.fluid.velocity[at(i)]); },
        [](double a, double b) { return std::max(a, b); });
    const double ahead =
        0.5 * dt * std::max(std::sqrt(fastest), speed_of_joints(model, scratch.is_loose, state.bodies, scratch.joints));
    if (coupling.near_travel < 0 || coupling.near_travel + ahead > margin) {
        const double closing = has_joints(model, scratch.is_loose) ? water.sph.spacing : 0;  // of faces, see JointPairs
        coupling.near_samples = near_samples(water.samples, scratch.motion, scratch.is_still, state.fluid.position,
                                             places_of_openings_and_joints(model, scratch), water.sph.domain,
                                             water.sph.support_radius() + closing + margin + ahead);
        coupling.near_travel = 0;
    }
    coupling.near_travel += ahead;
    if (scratch.near_numbers != coupling.near_samples) {
        scratch.near_numbers = coupling.near_samples;
        scratch.walls = {};
        scratch.joints.pressure.forget();
    }
}

}  // namespace

std::size_t WaterScratch::bytes() const {
    std::size_t bytes = sph.bytes() + walls.bytes() + penalty.bytes() + motion.bytes() + loads.bytes() +
                        held_loads.bytes() + bytes_of(near_numbers) +
                        bytes_of(force, torque, extra_force, sponge.force, sponge.before, correction) + joints.bytes() +
                        bytes_of(kappa, inertia, is_still, is_loose, guard_share, kinematics.angular_velocity) +
                        bytes_of(kinematics.inverse_inertia, kinematics.inverse_mass);
    body::BodyState::visit_fields(middle, [&](std::string_view, const auto& field) { bytes += bytes_of(field); });
    return bytes;
}

WaterReport kick_water(const Model& model, State& state, WaterScratch& scratch, double dt) {
    const FluidModel& water = *model.fluid;
    const double time = state.time;
    WaterReport report;
    if (scratch.inertia.size() != at(model.bodies.size())) {
        describe_bodies(model, scratch);
    }
    std::vector<coupling::Acceleration> guess(at(model.bodies.size()));
    for (std::size_t b = 0; b < guess.size(); ++b) {
        guess[b] = {state.coupling.acceleration[b], state.coupling.angular_acceleration[b]};
    }

    scratch.correction = state.bodies.drive_rate;
    absorb_waves(water.absorptions, model.bodies, time, dt, water.sph, state.fluid, state.bodies);
    for (std::size_t b = 0; b < scratch.correction.size(); ++b) {
        scratch.correction[b] = (state.bodies.drive_rate[b] - scratch.correction[b]) / dt;
    }
    update_kinematics(model.bodies, state.bodies, time, scratch.kinematics);
    fill_motion(model, state.bodies, scratch.kinematics, guess, scratch.correction, time, 0, dt, scratch.motion);
    find_near_samples(model, state, scratch, dt);
    place_walls(model, state, 0, scratch);
    const double since_density = 0.5 * (state.coupling.previous_dt + dt);  // the first density is half a step old
    update_density(water.sph, state.fluid, scratch.walls, model.gravity.at(time), since_density, scratch.sph,
                   report.fluid);
    fluid::drift(water.sph, state.fluid, 0.5 * dt);

    scratch.middle = state.bodies;
    solid::drift(model.bodies, scratch.middle, time + 0.5 * dt, 0.5 * dt);
    update_kinematics(model.bodies, scratch.middle, time + 0.5 * dt, scratch.kinematics);
    std::vector<double> kappa = scratch.kappa;
    for (std::size_t b = 0; b < kappa.size(); ++b) {
        kappa[b] = scratch.kinematics.inverse_mass[b] > 0 ? kappa[b] : 0;
    }
    coupling::AddedMassIteration iteration(model.bodies.mass, scratch.inertia, kappa);
    std::vector<coupling::Acceleration> found(guess.size());
    const double middle = time + 0.5 * dt;
    fill_motion(model, scratch.middle, scratch.kinematics, guess, scratch.correction, middle, 0.5 * dt, dt,
                scratch.motion);
    place_walls(model, state, 0.5 * dt, scratch);
    begin_forces(water.sph, state.fluid, scratch.walls, time, scratch.sph, report.fluid);
    if (!report.ok()) {
        return report;
    }
    if (water.wall == WallTreatment::boundary_particles) {
        scratch.penalty.push(model.shapes, model.bodies, scratch.motion, water.is_dry,
                             coupling::guard_settings(water.sph), scratch.guard_share, state.fluid, scratch.extra_force,
                             scratch.held_loads);
        add_joint_loads(model, scratch, model.gravity.at(middle));
    }
    for (bool is_settled = false; !is_settled;) {
        load_bodies(model, state, scratch, guess, dt);
        for (std::size_t b = 0; b < found.size(); ++b) {
            found[b] = response(state, scratch, b);
        }
        is_settled = iteration.accept(guess, found, norm(model.gravity.value));
    }
    if (!water.sponges.empty()) {
        push_sponges(water.sponges, water.sph, state.fluid, dt, scratch.extra_force, scratch.sponge);
    }
    kick_fluid(water.sph, state.fluid, scratch.walls, model.gravity.at(middle), dt, time, scratch.sph, report.fluid,
               scratch.extra_force);
    const double joint_work = dt * joint_power(scratch);
    report.fluid.work_on_solids += joint_work;  // by water that no particle stands for
    report.fluid.work_external += joint_work;
    report.absorbed = water.sponges.empty() ? 0 : absorbed_energy(state.fluid, dt, scratch.sponge);
    report.flow_work = dt * power_on_openings(scratch.walls, scratch.near_numbers.size());
    report.passes = iteration.passes();
    report.residual = iteration.residual();
    report.is_settled = iteration.is_settled();
    report.intruder = find_intruder(model, scratch);
    for (std::size_t b = 0; b < found.size(); ++b) {
        if (scratch.kinematics.inverse_mass[b] > 0) {
            report.work_on_free += dt * (dot(scratch.force[b], scratch.motion.velocity[b]) +
                                         dot(scratch.torque[b], scratch.motion.angular_velocity[b]));
        }
    }
    return report;
}

fluid::Passage end_water_step(const Model& model, State& state, const fluid::FluidReport& kicked, WaterScratch& scratch,
                              double dt) {
    const FluidModel& water = *model.fluid;
    fluid::drift(water.sph, state.fluid, 0.5 * dt);
    const double fastest =
        std::max(kicked.max_speed, speed_of_joints(model, scratch.is_loose, state.bodies, scratch.joints));
    state.coupling.near_travel += 0.5 * dt * fastest + kicked.max_shift;
    if (water.open.empty()) {
        return {};
    }
    const double time = state.time + dt;
    return pass_openings(water.open, water.sph, scratch.walls, scratch.near_numbers.size(),
                         without_periodic(model.gravity.at(time), water.sph.domain), time, dt, state.open, state.fluid);
}

void note_accelerations(const Model& model, const body::BodyState& before, State& state, const WaterScratch& scratch,
                        double dt) {
    CouplingState& coupling = state.coupling;
    for (std::int32_t i = 0; i < model.bodies.size(); ++i) {
        const auto b = at(i);
        if (scratch.kinematics.inverse_mass[b] == 0) {
            coupling.acceleration[b] = coupling.angular_acceleration[b] = {};
            coupling.dry_acceleration[b] = model.gravity.at(state.time + dt);  // should it be released next
            coupling.dry_angular_acceleration[b] = {};
            continue;
        }
        coupling.acceleration[b] = (state.bodies.velocity[b] - before.velocity[b]) / dt;
        coupling.angular_acceleration[b] = (angular_velocity(model.bodies, state.bodies, BodyId{i}) -
                                            angular_velocity(model.bodies, before, BodyId{i})) /
                                           dt;
        coupling.dry_acceleration[b] = coupling.acceleration[b] - scratch.kinematics.inverse_mass[b] * scratch.force[b];
        coupling.dry_angular_acceleration[b] =
            coupling.angular_acceleration[b] - scratch.kinematics.inverse_inertia[b] * scratch.torque[b];
    }
    coupling.previous_dt = dt;
}

double work_done(const Model& model, const body::BodyState& before, const State& state, const WaterScratch& scratch) {
    double work = 0;
    for (std::size_t b = 0; b < at(model.bodies.size()); ++b) {
        if (scratch.kinematics.inverse_mass[b] > 0) {
            const Vec3 turn = to_rotation_vector(state.bodies.orientation[b] * conjugate(before.orientation[b]));
            work += dot(scratch.force[b], state.bodies.position[b] - before.position[b]) + dot(scratch.torque[b], turn);
        }
    }
    return work;
}

void reset(const Model& model, CouplingState& coupling) {
    const auto count = model.fluid ? at(model.bodies.size()) : 0;
    coupling.previous_dt = 0;
    coupling.near_samples.clear();
    coupling.near_travel = -1;
    coupling.acceleration.assign(count, {});
    coupling.angular_acceleration.assign(count, {});
    coupling.dry_acceleration.assign(count, model.gravity.at(0));
    coupling.dry_angular_acceleration.assign(count, {});
}

}  // namespace riprap::sim
