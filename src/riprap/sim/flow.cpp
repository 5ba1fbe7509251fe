// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/flow.hpp"

#include <algorithm>

#include "riprap/core/index.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/coupling/added_mass.hpp"
#include "riprap/sim/ledger_table.hpp"
#include "riprap/sim/prediction.hpp"
#include "riprap/sim/trial.hpp"

namespace riprap::sim {

namespace {

/// Most passes whose guess is Newton's, where a fluid offers that. Water that does not pull gives the loads kinks; a
/// body at one of them may go to and fro between its sides, which the iteration that remembers all passes does not.
constexpr int most_newton_passes = 8;

/// Finds the loads of the fluid with which bodies accelerate as they were taken to, from the guess of the last step on.
void settle_light_bodies(const Model& model, const State& state, Fluid& fluid, const TimeSpan& span, ScratchData& data,
                         StepReport& report) {
    Prediction& prediction = data.prediction;
    const auto count = at(model.bodies.size());
    const std::span<const double> feedback = fluid.feedback();
    std::vector<double> kappa(count, 0);
    for (std::size_t b = 0; b < feedback.size(); ++b) {
        kappa[b] = prediction.kinematics.inverse_mass[b] > 0 ? feedback[b] : 0;
    }
    const std::vector<double> inertia = mean_inertia(model.bodies);
    coupling::AddedMassIteration iteration(model.bodies.mass, inertia, kappa);
    std::vector<std::uint8_t> is_sought(count);
    for (std::size_t b = 0; b < count; ++b) {
        is_sought[b] = kappa[b] > coupling::AddedMassIteration::iterates_above ? 1 : 0;
    }
    std::vector<body::Acceleration> found(count), tried;
    for (bool is_settled = false; !is_settled;) {
        predict_middle(model, span, prediction);
        fluid.load(span, prediction.middle, data.fluid_loads);
        add_up(model.bodies, data.fluid_loads, data.span_loads);
        for (std::size_t b = 0; b < count; ++b) {
            found[b] = response(model.bodies, state.coupling, prediction.kinematics, data.span_loads, b);
        }
        tried = prediction.guess;
        is_settled = iteration.accept(prediction.guess, found, norm(model.gravity.value));
        if (!fluid.corrects() || is_settled || iteration.passes() > most_newton_passes) {
            continue;
        }
        for (std::size_t b = 0; b < count; ++b) {
            found[b] = {found[b].linear - tried[b].linear, found[b].angular - tried[b].angular};
        }
        if (fluid.correct(model.bodies, prediction.kinematics, is_sought, found, tried)) {
            prediction.guess = tried;
        }
    }
    report.water_passes = std::max<std::int64_t>(report.water_passes, iteration.passes());
    report.water_residual = std::max(report.water_residual, iteration.residual());
    report.is_water_settled = report.is_water_settled && iteration.is_settled();
}

bool has_free_bodies(const body::BodyKinematics& kinematics) {
    return std::any_of(kinematics.inverse_mass.begin(), kinematics.inverse_mass.end(), [](double w) { return w > 0; });
}

/// The fluid from the beginning of a span to its loads and its kick.
Outcome flow(const Model& model, State& state, Fluid& fluid, Solid& solids, const Cycle& cycle, const TimeSpan& span,
             ScratchData& data, FluidSpan& brought, StepReport& report) {
    Prediction& prediction = data.prediction;
    const double since = span.time - state.time;
    fluid.drive(span, prediction.correction);
    predict(model, state, span, since, prediction);
    Outcome outcome = fluid.begin(span, prediction.now, prediction.middle, brought.step);
    if (!outcome.ok()) {
        return outcome;
    }
    settle_light_bodies(model, state, fluid, span, data, report);
    if (fluid.corrects() && cycle.spans == 1 &&
        has_free_bodies(prediction.kinematics)) {  // water that cannot give way: its loads follow the way of bodies
        const bool is_settled = settle_ways([&] { return foresee_contacts(model, state, solids, fluid, cycle, data); },
                                            [&] { settle_light_bodies(model, state, fluid, span, data, report); });
        report.is_water_settled = report.is_water_settled && is_settled;
    }
    outcome = fluid.kick(span, brought.step);
    brought.work_on_free = work_on_free(prediction, data.span_loads, span.dt);
    note_way(span.dt, prediction, state.coupling);
    note_gain(model, state, data.span_loads, span.dt, prediction);
    report.through_walls.add(brought.step.through_walls);
    if (report.intruder.empty()) {
        report.intruder = brought.step.intruder;
    }
    report.solver_iterations += brought.step.fluid.solver_iterations;
    report.solver_residual = std::max(report.solver_residual, brought.step.fluid.solver_residual);
    report.max_water_speed = std::max(report.max_water_speed, brought.step.fluid.max_speed);
    return outcome;
}

}  // namespace

Outcome flow_over(const Model& model, State& state, Fluid& fluid, Solid& solids, const Cycle& cycle, ScratchData& data,
                  std::vector<FluidSpan>& spans, StepReport& report) {
    const ScopedTimer timer(data.times.water);
    fluid.tidy(state.step);
    data.loads.clear(at(model.bodies.size()), state.bodies.deforms());
    data.prediction.guess = last_accelerations(state.coupling);
    data.prediction.gained.assign(at(model.bodies.size()), {});
    data.prediction.moved.assign(at(model.bodies.size()), {});
    begin_ways(model, state, cycle.dt, data.prediction);
    for (std::int64_t k = 0; k < cycle.spans; ++k) {
        Outcome outcome = flow(model, state, fluid, solids, cycle, cycle.span(k), data, spans.emplace_back(), report);
        if (!outcome.ok()) {
            return outcome;
        }
        add_share(data.span_loads, cycle.spans, data.loads);
        if (k + 1 < cycle.spans) {
            outcome = fluid.end(cycle.span(k), spans.back().step);
            if (!outcome.ok()) {
                return outcome;
            }
        }
    }
    return {};
}

Outcome end_flow(const Model& model, State& state, Fluid& fluid, const Cycle& cycle, ScratchData& data,
                 std::vector<FluidSpan>& spans, StepReport& report) {
    const ScopedTimer timer(data.times.water);
    const WorkDone work = work_done(data.before, state.bodies, data.prediction.kinematics, data.loads);
    note_missed_way(data.before, data.prediction, state);
    note_accelerations(model, data.before, data.prediction.kinematics, data.loads, cycle.dt, state);
    if (cycle.pieces > 1) {
        forget_impacts(model, data.prediction.kinematics, contact_loads(data), cycle.dt, state);
    }
    const Accounts accounts = accounts_of(model);
    const Outcome outcome = fluid.end(cycle.span(cycle.spans - 1), spans.back().step);
    if (!fluid.leads()) {
        // Such a fluid does not move by itself: its work is what the bodies say, whatever was predicted of them.
        for (FluidSpan& span : spans) {
            span.work_on_free = work.all() / static_cast<double>(spans.size());
        }
    } else if (const std::ptrdiff_t rest = rest_account(accounts); rest >= 0 && !fluid.feedback().empty()) {
        book_true_way(work.all(), static_cast<std::size_t>(rest), spans);
    } else if (const std::ptrdiff_t straining = fluid_account(accounts, straining_name); straining >= 0) {
        book_straining(work.strain, static_cast<std::size_t>(straining), spans);
    }
    book_fluid(spans, work.all(), accounts, state.ledger, report.ledger);
    return outcome;
}

}  // namespace riprap::sim
