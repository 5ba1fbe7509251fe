// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/fluid_exchange.hpp"

#include <cmath>

#include "riprap/body/locks.hpp"
#include "riprap/body/point_loads.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/coupling/added_mass.hpp"

namespace riprap::sim {

namespace {

/// Acceleration over that of gravity whose change within a step walls make up for, at most [-]: a contact
/// that takes up a weight changes it by no more. What an impact leaves out is nearly all of the way of the step, and
/// walls would go on with the speed that the body lost: a blow.
constexpr double most_catch_up = 1;

/// Share of the acceleration of a body and of gravity by which its way may differ from the one that the fluid was told
/// [-].
constexpr double other_way = 0.001;

Vec3 at_most(const Vec3& v, double size) { return norm(v) > size ? (size / norm(v)) * v : v; }

void add(std::span<const body::Acceleration> velocity, body::Motion& motion) {
    for (std::size_t b = 0; b < velocity.size(); ++b) {
        motion.velocity[b] += velocity[b].linear;
        motion.angular_velocity[b] += velocity[b].angular;
    }
}

}  // namespace

namespace {

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

namespace {

/// Returns the rotation of a body between two states [rad].
Vec3 turn_between(const body::BodyState& before, const body::BodyState& after, std::size_t b) {
    return to_rotation_vector(after.orientation[b] * conjugate(before.orientation[b]));
}

}  // namespace

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

bool go_another_way(const Model& model, const body::BodyState& before, const body::BodyState& after, double dt,
                    const body::Loads& loads, std::span<const double> feedback, Prediction& prediction,
                    coupling::CouplingState& coupling) {
    const std::vector<double> inertia = mean_inertia(model.bodies);
    const double per_way = 2 / (dt * dt), gravity = norm(model.gravity.value);
    bool is_other = false;
    for (std::size_t b = 0; b < prediction.guess.size(); ++b) {
        if (!(prediction.kinematics.inverse_mass[b] > 0)) {
            continue;
        }
        const body::Acceleration caught = prediction.catch_up.empty() ? body::Acceleration{} : prediction.catch_up[b];
        const body::Motion& seen = prediction.middle;
        const Vec3 way = after.position[b] - before.position[b] - dt * (seen.velocity[b] - caught.linear);
        const Vec3 turn = turn_between(before, after, b) - dt * (seen.angular_velocity[b] - caught.angular);
        const Vec3 more = per_way * way, faster = per_way * turn;
        body::Acceleration& guess = prediction.guess[b];
        const double arm = std::sqrt(inertia[b] / model.bodies.mass[b]);
        const body::Acceleration foreseen = response(model.bodies, coupling, prediction.kinematics, loads, b);
        const Vec3 pushed = more - (foreseen.linear - guess.linear),
                   turned = faster - (foreseen.angular - guess.angular);
        // The accelerations of bodies that are sought with their loads are not exact yet: what contacts add counts.
        const bool is_sought = b < feedback.size() && feedback[b] > coupling::AddedMassIteration::iterates_above;
        const double size = is_sought ? norm(pushed) + arm * norm(turned) : norm(more) + arm * norm(faster);
        is_other = is_other || size > other_way * (norm(guess.linear) + arm * norm(guess.angular) + gravity);
        coupling.dry_acceleration[b] += pushed;
        coupling.dry_angular_acceleration[b] += turned;
        guess = {guess.linear + more, guess.angular + faster};
    }
    return is_other;
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

void add_up(const body::BodySet& bodies, const coupling::FluidLoads& loads, body::Loads& sum) {
    const auto count = at(bodies.size());
    sum.clear(count, !loads.pressure.pull.empty());
    for (std::size_t b = 0; b < count; ++b) {
        const Vec3 f = loads.pressure.force[b] + loads.viscous.force[b];
        sum.force[b] = bodies.is_planar ? Vec3{f.x, f.y, 0} : f;
        sum.torque[b] = loads.pressure.torque[b] + loads.viscous.torque[b];
    }
    for (std::size_t b = 0; b < sum.pull.size(); ++b) {
        sum.pull[b] = loads.pressure.pull[b];
        sum.pull[b] += loads.viscous.pull[b];
    }
}

void add_share(const body::Loads& span, std::int64_t spans, body::Loads& step) {
    const double share = 1 / static_cast<double>(spans);
    for (std::size_t b = 0; b < step.size(); ++b) {
        step.force[b] += share * span.force[b];
        step.torque[b] += share * span.torque[b];
    }
    for (std::size_t b = 0; b < span.pull.size(); ++b) {
        step.pull[b] += share * span.pull[b];
    }
}

double work_on_free(const Prediction& prediction, const body::Loads& loads, double dt) {
    const body::Motion& motion = prediction.middle;
    double work = 0;
    for (std::size_t b = 0; b < loads.size(); ++b) {
        if (prediction.kinematics.inverse_mass[b] > 0) {
            work += dt * (dot(loads.force[b], motion.velocity[b]) + dot(loads.torque[b], motion.angular_velocity[b]));
        }
    }
    return work;
}

namespace {

/// Returns the strain of a body between two states, R (U_after - U_before) R^T with R halfway, world axes: exact to the
/// product of the strain and its change [-].
Sym3 strain_between(const body::BodyState& before, const body::BodyState& after, std::size_t b) {
    Sym3 change = after.stretch[b];
    change += -1.0 * before.stretch[b];
    Quat sum = before.orientation[b];
    const Quat& other = after.orientation[b];
    const double sign = sum.w * other.w + sum.x * other.x + sum.y * other.y + sum.z * other.z < 0 ? -1 : 1;
    sum = {sum.w + sign * other.w, sum.x + sign * other.x, sum.y + sign * other.y, sum.z + sign * other.z};
    const Mat3 turn = to_matrix(normalized(sum));
    const Mat3 body{
        {{change.xx, change.xy, change.xz}, {change.xy, change.yy, change.yz}, {change.xz, change.yz, change.zz}}};
    const Mat3 world = turn * body * transpose(turn);
    return {world(0, 0), world(1, 1), world(2, 2), world(0, 1), world(0, 2), world(1, 2)};
}

}  // namespace

WorkDone work_done(const body::BodyState& before, const body::BodyState& after, const body::BodyKinematics& kinematics,
                   const body::Loads& loads) {
    WorkDone work;
    for (std::size_t b = 0; b < loads.size(); ++b) {
        if (kinematics.inverse_mass[b] > 0) {
            work.motion += dot(loads.force[b], after.position[b] - before.position[b]) +
                           dot(loads.torque[b], turn_between(before, after, b));
            if (!loads.pull.empty() && before.deforms() && after.deforms()) {
                work.strain += contract(loads.pull[b], strain_between(before, after, b));
            }
        }
    }
    return work;
}

void note_accelerations(const Model& model, const body::BodyState& before, const body::BodyKinematics& kinematics,
                        const body::Loads& loads, double dt, State& state) {
    coupling::CouplingState& coupling = state.coupling;
    for (std::int32_t i = 0; i < model.bodies.size(); ++i) {
        const auto b = at(i);
        if (kinematics.inverse_mass[b] == 0) {
            coupling.acceleration[b] = coupling.angular_acceleration[b] = {};
            coupling.dry_acceleration[b] = model.gravity.at(state.time + dt);  // should it be released next
            coupling.dry_angular_acceleration[b] = {};
            continue;
        }
        coupling.acceleration[b] = (state.bodies.velocity[b] - before.velocity[b]) / dt;
        coupling.angular_acceleration[b] = (angular_velocity(model.bodies, state.bodies, BodyId{i}) -
                                            angular_velocity(model.bodies, before, BodyId{i})) /
                                           dt;
        coupling.dry_acceleration[b] = coupling.acceleration[b] - kinematics.inverse_mass[b] * loads.force[b];
        coupling.dry_angular_acceleration[b] =
            coupling.angular_acceleration[b] - kinematics.inverse_inertia[b] * loads.torque[b];
    }
}

namespace {

/// Returns `last`, where the push has ended, else `mean`.
Vec3 going_on(const Vec3& mean, const Vec3& last) { return dot(mean, last) < 0.5 * norm_squared(mean) ? last : mean; }

}  // namespace

void forget_impacts(const Model& model, const body::BodyKinematics& kinematics, const body::Loads& contacts, double dt,
                    State& state) {
    coupling::CouplingState& coupling = state.coupling;
    const Vec3 gravity = model.gravity.at(state.time + dt);
    body::PointLoadSum sum;
    const body::LoadView given = sum.add(model.loads, state.bodies, state.time + dt, {});
    for (std::size_t b = 0; b < contacts.size() && b < coupling.dry_acceleration.size(); ++b) {
        if (kinematics.inverse_mass[b] > 0) {
            Vec3 &linear = coupling.dry_acceleration[b], &angular = coupling.dry_angular_acceleration[b];
            const Vec3 steady = given.empty() ? gravity : gravity + kinematics.inverse_mass[b] * given.force[b];
            const Vec3 turning = given.empty() ? Vec3{} : kinematics.inverse_inertia[b] * given.torque[b];
            linear = steady + going_on(linear - steady, kinematics.inverse_mass[b] * contacts.force[b]);
            angular = turning + going_on(angular - turning, kinematics.inverse_inertia[b] * contacts.torque[b]);
        }
    }
}

void book_true_way(double work_given, std::size_t rest, std::span<FluidSpan> spans) {
    double foreseen = 0;
    for (const FluidSpan& span : spans) {
        foreseen += span.work_on_free;
    }
    const double more = (work_given - foreseen) / static_cast<double>(spans.size());
    for (FluidSpan& span : spans) {
        span.work_on_free += more;
        span.step.fluid.work_on_solids += more;
        span.step.own[rest] -= more;
    }
}

void book_straining(double work, std::size_t straining, std::span<FluidSpan> spans) {
    const double share = work / static_cast<double>(spans.size());
    for (FluidSpan& span : spans) {
        span.work_on_free += share;
        span.step.fluid.work_on_solids += share;
        span.step.own[straining] -= share;
    }
}

void book_fluid(std::span<const FluidSpan> spans, double work_given, const Accounts& accounts, LedgerState& state,
                Ledger& ledger) {
    double work_seen = 0;
    for (std::size_t k = 0; k < spans.size(); ++k) {
        work_seen += spans[k].work_on_free;
        const bool is_last = k + 1 == spans.size();
        Ledger earlier;  // the solids are booked once a step, with the last span
        account_fluid({spans[k].step, is_last ? work_seen : 0, is_last ? work_given : 0}, accounts, state,
                      is_last ? ledger : earlier);
        account_passage(spans[k].step.passage, state);
    }
}

void reset(const Model& model, coupling::CouplingState& coupling) {
    const auto count = model.has_fluid() ? at(model.bodies.size()) : 0;
    coupling.previous_dt = 0;
    coupling.near_samples.clear();
    coupling.near_travel = -1;
    coupling.acceleration.assign(count, {});
    coupling.angular_acceleration.assign(count, {});
    coupling.dry_acceleration.assign(count, model.gravity.at(0));
    coupling.dry_angular_acceleration.assign(count, {});
    const std::size_t walls = model.particles() != nullptr ? count : 0;
    coupling.missed_way.assign(walls, {});
    coupling.missed_turn.assign(walls, {});
    coupling.untold_way.assign(walls, {});
    coupling.untold_turn.assign(walls, {});
}

}  // namespace riprap::sim
