// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/prediction.hpp"

#include <cmath>
#include <span>

#include "riprap/body/locks.hpp"
#include "riprap/core/index.hpp"

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

}  // namespace

void predict(const Model& model, const State& state, const TimeSpan& span, double since, Prediction& prediction) {
    const body::BodySet& bodies = model.bodies;
    prediction.bodies = state.bodies;
    if (since > 0) {
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
    predict_middle(model, span, prediction);
    tell_density(state.coupling, span.dt, prediction);
}

void predict_middle(const Model& model, const TimeSpan& span, Prediction& prediction) {
    fill_motion(model.bodies, prediction.bodies, prediction.kinematics, prediction.guess, prediction.correction,
                span.middle(), 0.5 * span.dt, span.dt, prediction.middle);
    add(prediction.gained, prediction.middle);
    add(prediction.catch_up, prediction.middle);
}

void note_gain(const Model& model, const State& state, const body::Loads& loads, double dt, Prediction& prediction) {
    for (std::size_t b = 0; b < prediction.gained.size(); ++b) {
        if (prediction.kinematics.inverse_mass[b] > 0) {
            const body::Acceleration a = response(model.bodies, state.coupling, prediction.kinematics, loads, b);
            const body::Locks locks = body::locks_of(model.bodies, b);
            prediction.moved[b] += dt * (prediction.gained[b].linear + 0.5 * dt * a.linear);
            prediction.gained[b].linear += dt * a.linear;
            prediction.gained[b].angular += dt * locks.free_rotation(a.angular);
        }
    }
}

void begin_ways(const Model& model, const State& state, double dt, Prediction& prediction) {
    const coupling::CouplingState& coupling = state.coupling;
    prediction.way.assign(at(model.bodies.size()), {});
    prediction.catch_up.resize(coupling.missed_way.size());
    const double speed = most_catch_up * 0.5 * dt * norm(model.gravity.at(state.time));
    for (std::size_t b = 0; b < prediction.catch_up.size(); ++b) {
        const Vec3 &way = coupling.missed_way[b], &turn = coupling.missed_turn[b];
        const Vec3 carried =
            angular_momentum_of(model.bodies, BodyId{static_cast<std::int32_t>(b)}, state.bodies.orientation[b], turn);
        const double arm = std::sqrt(dot(carried, turn) / (model.bodies.mass[b] * norm_squared(turn)));  // of gyration
        prediction.catch_up[b] = {at_most(way / dt, speed), arm > 0 ? at_most(turn / dt, speed / arm) : Vec3{}};
    }
}

void note_way(double dt, Prediction& prediction, coupling::CouplingState& coupling) {
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

void note_missed_way(const body::BodyState& before, const Prediction& prediction, State& state) {
    coupling::CouplingState& coupling = state.coupling;
    const body::BodyState& after = state.bodies;
    for (std::size_t b = 0; b < coupling.missed_way.size(); ++b) {
        const bool is_free = prediction.kinematics.inverse_mass[b] > 0;
        const body::Acceleration& seen = prediction.way[b];
        coupling.missed_way[b] = is_free ? after.position[b] - before.position[b] - seen.linear : Vec3{};
        coupling.missed_turn[b] = is_free ? turn_between(before, after, b) - seen.angular : Vec3{};
    }
}

std::vector<body::Acceleration> last_accelerations(const coupling::CouplingState& coupling) {
    std::vector<body::Acceleration> found(coupling.acceleration.size());
    for (std::size_t b = 0; b < found.size(); ++b) {
        found[b] = {coupling.acceleration[b], coupling.angular_acceleration[b]};
    }
    return found;
}

body::Acceleration response(const body::BodySet& bodies, const coupling::CouplingState& coupling,
                            const body::BodyKinematics& kinematics, const body::Loads& loads, std::size_t b) {
    const body::Locks locks = locks_of(bodies, b);
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
