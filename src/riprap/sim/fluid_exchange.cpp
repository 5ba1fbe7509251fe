// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/fluid_exchange.hpp"

#include <cmath>

#include "riprap/body/locks.hpp"
#include "riprap/body/point_loads.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/sim/prediction.hpp"

namespace riprap::sim {

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

WorkDone work_done(const StepContext& step) {
    const body::BodyState &before = step.scratch.before, &after = step.state.bodies;
    const body::BodyKinematics& kinematics = step.scratch.prediction.kinematics;
    const body::Loads& loads = step.scratch.loads;
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

void note_accelerations(StepContext& step) {
    const Model& model = step.model;
    State& state = step.state;
    const body::BodyState& before = step.scratch.before;
    const body::BodyKinematics& kinematics = step.scratch.prediction.kinematics;
    const body::Loads& loads = step.scratch.loads;
    const double dt = step.cycle.dt;
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

void forget_impacts(StepContext& step) {
    const State& state = step.state;
    const body::BodyKinematics& kinematics = step.scratch.prediction.kinematics;
    const body::Loads& contacts = contact_loads(step.scratch);
    coupling::CouplingState& coupling = step.state.coupling;
    const double end = state.time + step.cycle.dt;
    const Vec3 gravity = step.model.gravity.at(end);
    body::PointLoadSum sum;
    const body::LoadView given = sum.add(step.model.loads, state.bodies, end, {});
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
        span.step.balance.work_on_solids += more;
        span.step.own[rest] -= more;
    }
}

void book_straining(double work, std::size_t straining, std::span<FluidSpan> spans) {
    const double share = work / static_cast<double>(spans.size());
    for (FluidSpan& span : spans) {
        span.work_on_free += share;
        span.step.balance.work_on_solids += share;
        span.step.own[straining] -= share;
    }
}

void book_fluid(StepContext& step, double work_given) {
    const std::vector<FluidSpan>& spans = step.spans;
    LedgerState& totals = step.state.ledger;
    double work_seen = 0;
    for (std::size_t k = 0; k < spans.size(); ++k) {
        work_seen += spans[k].work_on_free;
        const bool is_last = k + 1 == spans.size();
        Ledger earlier;  // the solids are booked once a step, with the last span
        account_fluid({spans[k].step, is_last ? work_seen : 0, is_last ? work_given : 0}, step.accounts, totals,
                      is_last ? step.report.ledger : earlier);
        account_transport(spans[k].step.transported, totals);
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
