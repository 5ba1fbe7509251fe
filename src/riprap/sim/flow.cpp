// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/flow.hpp"

#include <algorithm>
#include <utility>

#include "riprap/core/index.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/coupling/added_mass.hpp"
#include "riprap/sim/fluid_exchange.hpp"
#include "riprap/sim/prediction.hpp"
#include "riprap/sim/time_step.hpp"
#include "riprap/sim/trial.hpp"

namespace riprap::sim {

namespace {

/// Most passes whose guess is Newton's, where a fluid offers that. Water that does not pull gives the loads kinks; a
/// body at one of them may go to and fro between its sides, which the iteration that remembers all passes does not.
constexpr int most_newton_passes = 8;

/// Finds the loads of the fluid with which bodies accelerate as they were taken to, from the guess of the last step on.
void settle_light_bodies(StepContext& step, const TimeSpan& span) {
    const body::BodySet& bodies = step.model.bodies;
    ScratchData& data = step.scratch;
    Prediction& prediction = data.prediction;
    coupling::FluidMethod& fluid = step.fluid;
    const auto count = at(bodies.size());
    const std::span<const double> feedback = fluid.feedback();
    std::vector<double> kappa(count, 0);
    for (std::size_t b = 0; b < feedback.size(); ++b) {
        kappa[b] = prediction.kinematics.inverse_mass[b] > 0 ? feedback[b] : 0;
    }
    const std::vector<double> inertia = mean_inertia(bodies);
    coupling::AddedMassIteration iteration(bodies.mass, inertia, kappa);
    std::vector<std::uint8_t> is_sought(count);
    for (std::size_t b = 0; b < count; ++b) {
        is_sought[b] = kappa[b] > coupling::AddedMassIteration::iterates_above ? 1 : 0;
    }
    std::vector<body::Acceleration> found(count), tried;
    for (bool is_settled = false; !is_settled;) {
        predict_middle(step, span);
        fluid.load(span, prediction.middle, data.fluid_loads);
        add_up(bodies, data.fluid_loads, data.span_loads);
        for (std::size_t b = 0; b < count; ++b) {
            found[b] = response(step, b);
        }
        tried = prediction.guess;
        is_settled = iteration.accept(prediction.guess, found, norm(step.model.gravity.value));
        if (!fluid.corrects() || is_settled || iteration.passes() > most_newton_passes) {
            continue;
        }
        for (std::size_t b = 0; b < count; ++b) {
            found[b] = {found[b].linear - tried[b].linear, found[b].angular - tried[b].angular};
        }
        if (fluid.correct(bodies, prediction.kinematics, is_sought, found, tried)) {
            prediction.guess = tried;
        }
    }
    StepReport& report = step.report;
    report.fluid_passes = std::max<std::int64_t>(report.fluid_passes, iteration.passes());
    report.fluid_residual = std::max(report.fluid_residual, iteration.residual());
    report.is_fluid_settled = report.is_fluid_settled && iteration.is_settled();
}

bool has_free_bodies(const body::BodyKinematics& kinematics) {
    return std::any_of(kinematics.inverse_mass.begin(), kinematics.inverse_mass.end(), [](double w) { return w > 0; });
}

/// Finds the loads of the fluid over a span; of a fluid that cannot give way those that follow the way of bodies.
void find_loads(StepContext& step, const TimeSpan& span) {
    settle_light_bodies(step, span);
    if (step.fluid.corrects() && step.cycle.spans == 1 && has_free_bodies(step.scratch.prediction.kinematics)) {
        const bool is_settled =
            settle_ways([&] { return foresee_contacts(step); }, [&] { settle_light_bodies(step, span); });
        step.report.is_fluid_settled = step.report.is_fluid_settled && is_settled;
    }
}

/// Adds what the fluid reports of a span to the report of the step.
void join(const coupling::FluidStep& span, StepReport& all) {
    all.particles.add(span.particles);
    all.solver_iterations += span.balance.solver_iterations;
    all.solver_residual = std::max(all.solver_residual, span.balance.solver_residual);
    all.max_fluid_speed = std::max(all.max_fluid_speed, span.balance.max_speed);
}

}  // namespace

Outcome begin_flow(StepContext& step) {
    if (!step.model.has_fluid()) {
        return {};
    }
    if (std::string problem = fixed_step_problem(step.model, step.state, step.fluid_limit); !problem.empty()) {
        return {std::move(problem)};
    }
    const ScopedTimer timer(step.scratch.times.fluid);
    step.fluid.tidy(step.state.step);
    step.scratch.before = step.state.bodies;
    step.scratch.loads.clear(at(step.model.bodies.size()), step.state.bodies.deforms());
    step.loads = step.scratch.loads;
    begin_prediction(step);
    return {};
}

Outcome flow(StepContext& step, std::int64_t k) {
    const ScopedTimer timer(step.scratch.times.fluid);
    const TimeSpan span = step.cycle.span(k);
    const Prediction& prediction = step.scratch.prediction;
    FluidSpan& brought = step.spans.emplace_back();
    Outcome outcome = step.fluid.begin(span, prediction.now, prediction.middle, brought.step);
    if (!outcome.ok()) {
        return outcome;
    }
    find_loads(step, span);
    outcome = step.fluid.kick(span, brought.step);
    brought.work_on_free = work_on_free(prediction, step.scratch.span_loads, span.dt);
    note_way(step, span.dt);
    note_gain(step, span.dt);
    join(brought.step, step.report);
    if (!outcome.ok()) {
        return outcome;
    }
    add_share(step.scratch.span_loads, step.cycle.spans, step.scratch.loads);
    const bool is_last = k + 1 == step.cycle.spans;
    return is_last ? outcome : step.fluid.end(span, brought.step);
}

Outcome book(StepContext& step) {
    if (!step.model.has_fluid()) {
        return {};
    }
    const ScopedTimer timer(step.scratch.times.fluid);
    const WorkDone work = work_done(step);
    note_missed_way(step);
    note_accelerations(step);
    if (step.cycle.pieces > 1) {
        forget_impacts(step);
    }
    std::vector<FluidSpan>& spans = step.spans;
    Outcome outcome = step.fluid.end(step.cycle.span(step.cycle.spans - 1), spans.back().step);
    if (!step.fluid_leads) {
        // Such a fluid does not move by itself: its work is what the bodies say, whatever was predicted of them.
        for (FluidSpan& span : spans) {
            span.work_on_free = work.all() / static_cast<double>(spans.size());
        }
    } else if (const std::ptrdiff_t rest = rest_account(step.accounts); rest >= 0 && !step.fluid.feedback().empty()) {
        book_true_way(work.all(), static_cast<std::size_t>(rest), spans);
    } else if (const std::ptrdiff_t straining = fluid_account(step.accounts, straining_name); straining >= 0) {
        book_straining(work.strain, static_cast<std::size_t>(straining), spans);
    }
    book_fluid(step, work.all());
    return outcome;
}

}  // namespace riprap::sim
