// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/water_step.hpp"

#include <algorithm>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/fluid/sph/kick.hpp"
#include "riprap/sim/water_walls.hpp"

namespace riprap::sim {

namespace {

/// How bodies sped up over the last step: the first guess of this one.
std::vector<body::Acceleration> accelerations_of_last_step(const CouplingState& coupling) {
    std::vector<body::Acceleration> found(coupling.acceleration.size());
    for (std::size_t b = 0; b < found.size(); ++b) {
        found[b] = {coupling.acceleration[b], coupling.angular_acceleration[b]};
    }
    return found;
}

/// What bodies do under the loads found: those of the water plus what else made them speed up in the last step.
body::Acceleration response(const State& state, const WaterScratch& scratch, std::size_t b) {
    return {scratch.kinematics.inverse_mass[b] * scratch.force[b] + state.coupling.dry_acceleration[b],
            scratch.kinematics.inverse_inertia[b] * scratch.torque[b] + state.coupling.dry_angular_acceleration[b]};
}

Vec3 in_plane_force(const Model& model, const Vec3& f) { return model.bodies.is_planar ? Vec3{f.x, f.y, 0} : f; }

/// Loads on bodies that speed up as `guess` says.
void load_bodies(const Model& model, const State& state, WaterScratch& scratch,
                 const std::vector<body::Acceleration>& guess, double dt) {
    place_walls_at_middle(model, state, guess, dt, scratch);
    const FluidModel& water = *model.fluid;
    const bool is_penalty = water.wall == WallTreatment::penalty;
    if (is_penalty) {
        scratch.penalty.push(model.shapes, model.bodies, scratch.motion, water.is_dry,
                             coupling::penalty_settings(water.sph), {}, state.fluid, scratch.extra_force,
                             scratch.loads);
    }
    load_walls(water.sph, state.fluid, scratch.walls, model.gravity.at(state.time + 0.5 * dt), scratch.sph);
    if (!is_penalty) {
        gather_loads(samples_near_water(model, scratch), scratch.motion, scratch.walls, scratch.loads);
        for (std::size_t b = 0; b < scratch.held_loads.pressure.force.size(); ++b) {
            scratch.loads.pressure.force[b] += scratch.held_loads.pressure.force[b];
            scratch.loads.pressure.torque[b] += scratch.held_loads.pressure.torque[b];
        }
    }
    const auto count = at(model.bodies.size());
    scratch.force.resize(count);
    scratch.torque.resize(count);
    for (std::size_t b = 0; b < count; ++b) {
        scratch.force[b] = in_plane_force(model, scratch.loads.pressure.force[b] + scratch.loads.viscous.force[b]);
        scratch.torque[b] = scratch.loads.pressure.torque[b] + scratch.loads.viscous.torque[b];
    }
}

/// Paddles correct their motion by what the water does; how that speeds them up goes to scratch.correction.
void drive_paddles(const Model& model, State& state, WaterScratch& scratch, double dt) {
    const FluidModel& water = *model.fluid;
    scratch.correction = state.bodies.drive_rate;
    absorb_waves(water.absorptions, model.bodies, state.time, dt, water.sph, state.fluid, state.bodies);
    for (std::size_t b = 0; b < scratch.correction.size(); ++b) {
        scratch.correction[b] = (state.bodies.drive_rate[b] - scratch.correction[b]) / dt;
    }
}

/// Bodies at mid-step as they drift there, to scratch.middle.
void predict_bodies(const Model& model, const State& state, WaterScratch& scratch, double dt) {
    const double middle = state.time + 0.5 * dt;
    scratch.middle = state.bodies;
    solid::drift(model.bodies, scratch.middle, middle, 0.5 * dt);
    update_kinematics(model.bodies, scratch.middle, middle, scratch.kinematics);
}

/// Loads that do not change while accelerations of bodies are iterated: of the guard before faces, and of joints.
void hold_loads(const Model& model, const State& state, WaterScratch& scratch, double dt) {
    const FluidModel& water = *model.fluid;
    if (water.wall != WallTreatment::boundary_particles) {
        return;
    }
    scratch.penalty.push(model.shapes, model.bodies, scratch.motion, water.is_dry,
                         coupling::guard_settings(water.sph, dt), scratch.guard_share, state.fluid, scratch.extra_force,
                         scratch.held_loads);
    add_joint_loads(model, scratch, model.gravity.at(state.time + 0.5 * dt));
}

/// Loads with which bodies speed up as they were taken to: passes of the force, from `guess` on.
void settle_bodies(const Model& model, const State& state, WaterScratch& scratch,
                   std::vector<body::Acceleration>& guess, double dt, WaterReport& report) {
    std::vector<double> kappa = scratch.kappa;
    for (std::size_t b = 0; b < kappa.size(); ++b) {
        kappa[b] = scratch.kinematics.inverse_mass[b] > 0 ? kappa[b] : 0;
    }
    coupling::AddedMassIteration iteration(model.bodies.mass, scratch.inertia, kappa);
    std::vector<body::Acceleration> found(guess.size());
    for (bool is_settled = false; !is_settled;) {
        load_bodies(model, state, scratch, guess, dt);
        for (std::size_t b = 0; b < found.size(); ++b) {
            found[b] = response(state, scratch, b);
        }
        is_settled = iteration.accept(guess, found, norm(model.gravity.value));
    }
    report.passes = iteration.passes();
    report.residual = iteration.residual();
    report.is_settled = iteration.is_settled();
}

/// What the kick did on bodies, through openings and in sponges.
void account(const Model& model, const State& state, const WaterScratch& scratch, double dt, WaterReport& report) {
    const double joint_work = dt * joint_power(scratch);
    report.fluid.work_on_solids += joint_work;  // by water that no particle stands for
    report.fluid.work_external += joint_work;
    report.absorbed = model.fluid->sponges.empty() ? 0 : absorbed_energy(state.fluid, dt, scratch.sponge);
    report.flow_work = dt * power_on_openings(scratch.walls, scratch.near_numbers.size());
    for (std::size_t b = 0; b < scratch.force.size(); ++b) {
        if (scratch.kinematics.inverse_mass[b] > 0) {
            report.work_on_free += dt * (dot(scratch.force[b], scratch.motion.velocity[b]) +
                                         dot(scratch.torque[b], scratch.motion.angular_velocity[b]));
        }
    }
}

}  // namespace

WaterReport kick_water(const Model& model, State& state, WaterScratch& scratch, double dt) {
    const FluidModel& water = *model.fluid;
    const double time = state.time;
    const double middle = time + 0.5 * dt;
    WaterReport report;
    if (scratch.inertia.size() != at(model.bodies.size())) {
        describe_bodies(model, scratch);
    }
    std::vector<body::Acceleration> guess = accelerations_of_last_step(state.coupling);

    drive_paddles(model, state, scratch, dt);
    place_walls_at_start(model, state, guess, dt, scratch);
    const double since_density = 0.5 * (state.coupling.previous_dt + dt);  // the first density is half a step old
    update_density(water.sph, state.fluid, scratch.walls, model.gravity.at(time), since_density, scratch.sph,
                   report.fluid);
    fluid::drift(water.sph, state.fluid, 0.5 * dt);

    predict_bodies(model, state, scratch, dt);
    place_walls_at_middle(model, state, guess, dt, scratch);
    begin_forces(water.sph, state.fluid, scratch.walls, time, scratch.sph, report.fluid);
    if (!report.ok()) {
        return report;
    }
    hold_loads(model, state, scratch, dt);
    settle_bodies(model, state, scratch, guess, dt, report);
    if (!water.sponges.empty()) {
        push_sponges(water.sponges, water.sph, state.fluid, dt, scratch.extra_force, scratch.sponge);
    }
    kick_fluid(water.sph, state.fluid, scratch.walls, model.gravity.at(middle), dt, time, scratch.sph, report.fluid,
               scratch.extra_force);
    account(model, state, scratch, dt, report);
    report.intruder = find_intruder(model, scratch);
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
