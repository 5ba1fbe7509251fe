// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/prediction.hpp"

#include <cmath>
#include <span>

#include "riprap/body/locks.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/timer.hpp"

namespace riprap::sim {

namespace {

/// Acceleration over that of gravity whose change within a step walls make up for, at most [-]: a contact
/// that takes up a weight changes it by no more. What an impact leaves out is nearly all of the way of the step, and
/// walls would go on with the speed that the body lost: a blow.
constexpr double most_catch_up = 1;

Vec3 at_most(const Vec3& v, double size) { return norm(v) > size ? (size / norm(v)) * v : v; }

void add(std::span<const body::Acceleration> velocity, body::Motion& motion) {
    for (std::size_t b = 0; b < velocity.size(); ++b) {
        motion.velocity[b] += velocity[b].linear;
        motion.angular_velocity[b] += velocity[b].angular;
    }
}

/// Lets walls move at t_n, where the density of water is carried from mid-step to mid-step, with the mean velocity that
/// brings them as far as the forces of both steps moved them: what compression takes is what their work gives.
void tell_density(const coupling::CouplingState& coupling, double dt, Prediction& prediction) {
    const double between = 0.5 * (coupling.previous_dt + dt);
    prediction.told.resize(coupling.untold_way.size());
    for (std::size_t b = 0; b < prediction.told.size(); ++b) {
        body::Acceleration& told = prediction.told[b];
        told = {0.5 * dt * prediction.middle.velocity[b], 0.5 * dt * prediction.middle.angular_velocity[b]};
        prediction.now.velocity[b] = (coupling.untold_way[b] + told.linear) / between;
        prediction.now.angular_velocity[b] = (coupling.untold_turn[b] + told.angular) / between;
    }
}

/// Returns the accelerations over the last step.
std::vector<body::Acceleration> last_accelerations(const coupling::CouplingState& coupling) {
    std::vector<body::Acceleration> found(coupling.acceleration.size());
    for (std::size_t b = 0; b < found.size(); ++b) {
        found[b] = {coupling.acceleration[b], coupling.angular_acceleration[b]};
    }
    return found;
}

}  // namespace

void predict(StepContext& step, const TimeSpan& span) {
    const ScopedTimer timer(step.scratch.times.fluid);
    const body::BodySet& bodies = step.model.bodies;
    Prediction& prediction = step.scratch.prediction;
    step.fluid.drive(span, prediction.correction);
    prediction.bodies = step.state.bodies;
    if (const double since = span.time - step.state.time; since > 0) {
        solid::drift(bodies, prediction.bodies, span.time, since);
        for (std::size_t b = 0; b < prediction.moved.size(); ++b) {
            prediction.bodies.position[b] += prediction.moved[b];
        }
    }
    update_kinematics(bodies, prediction.bodies, span.time, prediction.kinematics);
    fill_motion(bodies, prediction.bodies, prediction.kinematics, prediction.guess, prediction.correction, span.time, 0,
                span.dt, prediction.now);
    add(prediction.gained, prediction.now);
    add(prediction.catch_up, prediction.now);
    solid::drift(bodies, prediction.bodies, span.middle(), 0.5 * span.dt);
    for (std::size_t b = 0; b < prediction.gained.size(); ++b) {
        prediction.bodies.position[b] += 0.5 * span.dt * prediction.gained[b].linear;
    }
    update_kinematics(bodies, prediction.bodies, span.middle(), prediction.kinematics);
    predict_middle(step, span);
    tell_density(step.state.coupling, span.dt, prediction);
}

void predict_middle(StepContext& step, const TimeSpan& span) {
    Prediction& prediction = step.scratch.prediction;
    fill_motion(step.model.bodies, prediction.bodies, prediction.kinematics, prediction.guess, prediction.correction,
                span.middle(), 0.5 * span.dt, span.dt, prediction.middle);
    add(prediction.gained, prediction.middle);
    add(prediction.catch_up, prediction.middle);
}

void note_gain(StepContext& step, double dt) {
    Prediction& prediction = step.scratch.prediction;
    for (std::size_t b = 0; b < prediction.gained.size(); ++b) {
        if (prediction.kinematics.inverse_mass[b] > 0) {
            const body::Acceleration a = response(step, b);
            const body::Locks locks = body::locks_of(step.model.bodies, b);
            prediction.moved[b] += dt * (prediction.gained[b].linear + 0.5 * dt * a.linear);
            prediction.gained[b].linear += dt * a.linear;
            prediction.gained[b].angular += dt * locks.free_rotation(a.angular);
        }
    }
}

void begin_prediction(StepContext& step) {
    const Model& model = step.model;
    const State& state = step.state;
    const coupling::CouplingState& coupling = state.coupling;
    Prediction& prediction = step.scratch.prediction;
    const std::size_t count = at(model.bodies.size());
    prediction.guess = last_accelerations(coupling);
    prediction.gained.assign(count, {});
    prediction.moved.assign(count, {});
    prediction.way.assign(count, {});
    prediction.catch_up.resize(coupling.missed_way.size());
    const double dt = step.cycle.dt;
    const double speed = most_catch_up * 0.5 * dt * norm(model.gravity.at(state.time));
    for (std::size_t b = 0; b < prediction.catch_up.size(); ++b) {
        const Vec3 &way = coupling.missed_way[b], &turn = coupling.missed_turn[b];
        const Vec3 carried =
            angular_momentum_of(model.bodies, BodyId{static_cast<std::int32_t>(b)}, state.bodies.orientation[b], turn);
        const double arm = std::sqrt(dot(carried, turn) / (model.bodies.mass[b] * norm_squared(turn)));  // of gyration
        prediction.catch_up[b] = {at_most(way / dt, speed), arm > 0 ? at_most(turn / dt, speed / arm) : Vec3{}};
    }
}

void note_way(StepContext& step, double dt) {
    Prediction& prediction = step.scratch.prediction;
    coupling::CouplingState& coupling = step.state.coupling;
    const body::Motion& seen = prediction.middle;
    for (std::size_t b = 0; b < prediction.told.size(); ++b) {
        coupling.untold_way[b] = dt * seen.velocity[b] - prediction.told[b].linear;
        coupling.untold_turn[b] = dt * seen.angular_velocity[b] - prediction.told[b].angular;
    }
    for (std::size_t b = 0; b < prediction.way.size(); ++b) {
        const body::Acceleration caught = prediction.catch_up.empty() ? body::Acceleration{} : prediction.catch_up[b];
        prediction.way[b].linear += dt * (seen.velocity[b] - caught.linear);
        prediction.way[b].angular += dt * (seen.angular_velocity[b] - caught.angular);
    }
}

Vec3 turn_between(const body::BodyState& before, const body::BodyState& after, std::size_t b) {
    return to_rotation_vector(after.orientation[b] * conjugate(before.orientation[b]));
}

void note_missed_way(StepContext& step) {
    const Prediction& prediction = step.scratch.prediction;
    coupling::CouplingState& coupling = step.state.coupling;
    const body::BodyState &before = step.scratch.before, &after = step.state.bodies;
    for (std::size_t b = 0; b < coupling.missed_way.size(); ++b) {
        const bool is_free = prediction.kinematics.inverse_mass[b] > 0;
        const body::Acceleration& seen = prediction.way[b];
        coupling.missed_way[b] = is_free ? after.position[b] - before.position[b] - seen.linear : Vec3{};
        coupling.missed_turn[b] = is_free ? turn_between(before, after, b) - seen.angular : Vec3{};
    }
}

body::Acceleration response(const StepContext& step, std::size_t b) {
    const coupling::CouplingState& coupling = step.state.coupling;
    const body::BodyKinematics& kinematics = step.scratch.prediction.kinematics;
    const body::Loads& loads = step.scratch.span_loads;
    const body::Locks locks = locks_of(step.model.bodies, b);
    return {locks.free_translation(kinematics.inverse_mass[b] * loads.force[b] + coupling.dry_acceleration[b]),
            kinematics.inverse_inertia[b] * loads.torque[b] + coupling.dry_angular_acceleration[b]};
}

std::vector<double> mean_inertia(const body::BodySet& bodies) {
    std::vector<double> inertia(bodies.principal_moments.size());
    for (std::size_t b = 0; b < inertia.size(); ++b) {
        const Vec3& moments = bodies.principal_moments[b];
        inertia[b] = bodies.is_planar ? moments.z : (moments.x + moments.y + moments.z) / 3;
    }
    return inertia;
}

}  // namespace riprap::sim
