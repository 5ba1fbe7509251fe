// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "riprap/core/parallel.hpp"
#include "riprap/run/remedy/end_causes.hpp"
#include "riprap/run/simulate/ledger_verdict.hpp"
#include "riprap/run/simulate/passage_verdict.hpp"
#include "riprap/run/simulate/state_hash.hpp"
#include "riprap/run/simulate/step_choice.hpp"
#include "riprap/sim/ledger_account.hpp"
#include "riprap/sim/ledger_table.hpp"

namespace riprap::run {

Simulation::Simulation(scene::LoadedCase loaded, const SettleWatch& settling)
    : loaded_(std::move(loaded)),
      initial_(loaded_.state),
      bound_(sim::time_step_bound(loaded_.model, loaded_.state)),
      watch_(loaded_.model) {
    if (model().time.settle > 0) {
        settle(loaded_, initial_, settling);
    }
    sim::initialise(model(), initial_);
    state_ = initial_;
    set_end(model().time.end, model().time.max_steps);
    watch_.look(now());
}

void Simulation::set_end(double end, std::int64_t max_steps) {
    loaded_.model.time.end = end;
    loaded_.model.time.max_steps = max_steps;
    forget_scratch();  // the length of a step may depend on the end
    next_ = choose_step(model(), state_, scratch_);
}

void Simulation::forget_scratch() {
    passages_.reset();
    scratch_.forget();
    has_stepped_ = false;
}

std::int64_t Simulation::steps_left() const {
    return max_steps() >= 0 ? std::clamp<std::int64_t>(max_steps() - state_.step, 0, next_.steps_left)
                            : next_.steps_left;
}

bool Simulation::next_ends() const {
    return next_.steps_left <= 1 || state_.time + next_.dt + 1e-6 * next_.dt >= end();
}

bool Simulation::next_is_last() const { return next_ends() || steps_left() <= 1; }

StepOutcome Simulation::step(sim::Measure measure, Use use) {
    if (!good_.is_there()) {
        keep_standing();
    }
    if (std::string problem = step_problem(model(), state_, next_.dt); !problem.empty()) {
        const sim::StepStatus why{std::move(problem), {}};
        return {StepOutcome::Kind::refused, with_advice({model(), state_, state_, scratch_, report_, why})};
    }
    const bool is_end = next_ends(), is_stop = next_is_last(), is_measured = measure == sim::Measure::energy;
    const bool is_judged = is_end || (is_measured && use == Use::record) || state_.step < first_steps ||
                           good_.is_due_after(state_.step + 1);
    sim::StepReport report = advance(model(), state_, scratch_, next_.dt,
                                     is_judged || is_measured ? sim::Measure::energy : sim::Measure::flow);
    if (report.status.ok()) {
        report.status.text = passages_.look(model(), state_, scratch_, report, is_end);
    }
    if (!report.status.ok()) {
        sim::State before = good_.now(model());
        return take_back(std::move(before), report);
    }
    sim::StepStatus problem{is_judged ? judge_step(report) : "", {}};
    if (problem.ok()) {
        problem = passed_walls(model(), state_, counts_.through_walls + report.particles.through_walls.count,
                               report.particles.through_walls);
    }
    if (!problem.ok()) {  // the fault may have begun at any step since the last one judged
        watch_.load(good_.last().expects);
        counts_ = good_.last().counts;
        good_.go_back();
        report.status = std::move(problem);
        return take_back(good_.last().state, report);
    }
    if (state_.step == first_steps) {
        keep_first_residual(accepted_miss(report.ledger, model(), state_), accounts_of(model()), state_.ledger);
    }
    stop_problem_ = is_stop && !is_judged ? problem_at_stop(report) : "";
    good_.add_step(next_.dt);
    report.ledger.has_energy = is_measured || state_.step == 1;
    report_ = std::move(report);
    has_stepped_ = true;
    next_ = choose_step(model(), state_, scratch_);
    counts_.add(report_, is_at_end());
    watch_.look(now());
    if (is_judged) {
        keep_standing();
    }
    return {};
}

std::string Simulation::judge_step(const sim::StepReport& report) const {
    std::string problem = ledger_problem(report.ledger, model(), state_, state_.step);
    return problem.empty() ? water_passage(model(), state_) : problem;
}

std::string Simulation::problem_at_stop(const sim::StepReport& report) const {
    const std::string problem = report.ledger.has_energy ? judge_step(report) : "";
    return problem.empty() ? PassageWatch::look_now(model(), state_) : problem;
}

void Simulation::keep_standing() { good_.keep({state_, watch_.save(), counts_}); }

StepOutcome Simulation::take_back(sim::State to, const sim::StepReport& report) {
    constexpr double as_long = 0.75;  // a step this long would be the same again: where it meets the end, say
    const double refused_dt = next_.dt;
    const sim::State after = std::exchange(state_, std::move(to));
    const sim::StepControl stepping = state_.stepping;
    sim::Scratch fresh;
    bool is_retried = halve_time_step(model(), state_);
    while (is_retried && !(choose_step(model(), state_, fresh).dt < as_long * refused_dt)) {
        is_retried = halve_time_step(model(), state_);
    }
    sim::StepStatus why = report.status;
    if (is_retried) {
        keep_standing();
        retries_ += 1;
    } else {
        state_.stepping = stepping;
        why = with_advice({model(), state_, after, scratch_, report, report.status});
    }
    forget_scratch();  // it may hold what is not a number
    next_ = choose_step(model(), state_, scratch_);
    return {is_retried ? StepOutcome::Kind::retried : StepOutcome::Kind::refused, std::move(why)};
}

void Simulation::note(RunRecord& record) const {
    record.end = end();
    record.max_steps = max_steps();
    record.retries = retries_;
    record.steps = counts_;
    record.expects = watch_.save();
    record.approached = passages_.approached();
    record.deep = passages_.deep();
    record.good = good_;
}

void Simulation::restore(sim::State state, const RunRecord& record) {
    watch_.load(record.expects);
    state_ = std::move(state);
    retries_ = record.retries;
    counts_ = record.steps;
    set_end(record.end, record.max_steps);
    passages_.restore(record.approached, record.deep);
    good_ = record.good;
    if (good_.steps().empty()) {
        keep_standing();
    }
}

std::vector<std::string> Simulation::totals() const {
    std::vector<std::string> texts = StepWatch::totals(counts_, state_.step);
    if (std::string text = artificial_text(report_.ledger, model()); !text.empty()) {
        texts.push_back(std::move(text));
    }
    if (std::string text = splash_text(model(), state_); !text.empty()) {
        texts.push_back(std::move(text));
    }
    if (!stop_problem_.empty()) {
        texts.push_back(fmt::format(
            "max_steps stopped the run where it would not have been accepted: {}; it is judged when it goes on",
            stop_problem_));
    }
    return texts;
}

Summary Simulation::summary() const {
    Summary summary;
    summary.title = model().title;
    summary.source = nlohmann::json::parse(loaded_.resolved_json).value("source", "");
    summary.state_hash = xxh3_of(state_);
    summary.steps = state_.step;
    summary.time = state_.time;
    summary.dt = report_.dt > 0 ? report_.dt : state_.previous_dt;
    summary.retries = retries_;
    summary.counts = counts_;
    summary.body_count = model().bodies.size();
    summary.particle_count = state_.fluid.size();
    summary.memory_bytes = sim::memory_bytes(model(), state_, scratch_);
    summary.threads = parallel::thread_count();
    summary.ledger = report_.ledger;
    summary.has_fluid = model().has_fluid();
    for (const sim::LedgerLine& line : sim::ledger_lines()) {
        if (has_line(model(), line)) {
            summary.accounts.push_back({line.name, value_of(line, model(), report_.ledger)});
        }
    }
    summary.stages = sim::stage_times(scratch_);
    summary.expects = judge();
    summary.warnings = loaded_.warnings;
    for (std::string& line : totals()) {
        summary.warnings.push_back(std::move(line));
    }
    summary.overrides = loaded_.overrides;
    return summary;
}

}  // namespace riprap::run
