// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/sim/ledger_table.hpp"

namespace riprap::run {

namespace {

/// Why a ledger ends the run; empty when it closes. Where hardly anything has turned over yet, round-off of the
/// energies that are there is all there is to see: a residual below 1e-9 of them says nothing. Nor do the first steps,
/// in which a contact that opens or closes between two kicks is not yet small beside what was turned over. Water is
/// resolved by its spacing: beside what was turned over stands what lifts all of it by one spacing, for when it is let
/// go its lattice settles by hundredths of that before anything flows.
std::string ledger_problem(const sim::Ledger& ledger, const sim::Model& model, std::int64_t step) {
    constexpr std::int64_t first_steps = 10;
    constexpr double round_off = 1e-9;
    const double tolerance = model.output.ledger_tolerance, residual = std::abs(ledger.residual);
    const double grain = model.particles() != nullptr
                             ? ledger.fluid.mass * norm(model.gravity.value) * model.particles()->settings().spacing
                             : 0;
    const double counted = std::max(ledger.turnover, grain);
    const double scale = std::max({std::abs(ledger.kinetic), std::abs(ledger.potential), ledger.turnover});
    if (!ledger.has_energy || step <= first_steps || ledger.turnover <= 0 || residual <= round_off * scale ||
        residual <= tolerance * counted) {
        return "";
    }
    const std::string unit = sim::unit_in("J", model.bodies.is_planar);
    return fmt::format(
        "the energy ledger misses {:.3g} {} of {:.3g} {} that count as turned over at t = {:.6g} s, more than "
        "output.ledger_tolerance = {:.3g} of it",
        ledger.residual, unit, counted, unit, ledger.time, tolerance);
}

}  // namespace

Simulation::Simulation(scene::LoadedCase loaded)
    : loaded_(std::move(loaded)),
      initial_(loaded_.state),
      bound_(sim::time_step_bound(loaded_.model, loaded_.state)),
      watch_(loaded_.model) {
    sim::initialise(model(), initial_);
    state_ = initial_;
    set_end(model().time.end, model().time.max_steps);
    watch_.look(now());
}

void Simulation::set_end(double end, std::int64_t max_steps) {
    loaded_.model.time.end = end;
    loaded_.model.time.max_steps = max_steps;
    forget_scratch();  // a step may be a share of the end
    good_ = {};        // and those already taken were chosen by the old one
    next_ = choose_time_step(model(), state_, scratch_);
}

void Simulation::forget_scratch() {
    scratch_.forget();
    has_stepped_ = false;
}

std::int64_t Simulation::steps_left() const {
    return max_steps() >= 0 ? std::clamp<std::int64_t>(max_steps() - state_.step, 0, next_.steps_left)
                            : next_.steps_left;
}

bool Simulation::next_is_last() const { return steps_left() <= 1 || state_.time + next_.dt + 1e-6 * next_.dt >= end(); }

StepOutcome Simulation::step(sim::Measure measure) {
    good_.keep(state_);
    const std::int64_t step = state_.step;
    sim::StepReport report = advance(model(), state_, scratch_, next_.dt, measure);
    const std::string problem = ledger_problem(report.ledger, model(), step + 1);
    if (!report.status.ok() || !problem.empty()) {
        state_ = good_.at(model(), step);
        const bool is_retried = !report.status.ok() && halve_time_step(model(), state_);
        if (is_retried) {
            good_.replace(state_);
            retries_ += 1;
        }
        forget_scratch();  // it may hold what is not a number
        next_ = choose_time_step(model(), state_, scratch_);
        return {is_retried ? StepOutcome::Kind::retried : StepOutcome::Kind::refused,
                report.status.ok() ? problem : report.status.text};
    }
    report_ = std::move(report);
    has_stepped_ = true;
    next_ = choose_time_step(model(), state_, scratch_);
    counts_.add(report_, is_at_end());
    watch_.look(now());
    return {};
}

void Simulation::note(RunRecord& record) const {
    record.end = end();
    record.max_steps = max_steps();
    record.retries = retries_;
    record.steps = counts_;
    record.expects = watch_.save();
}

void Simulation::restore(sim::State state, const RunRecord& record) {
    watch_.load(record.expects);
    state_ = std::move(state);
    retries_ = record.retries;
    counts_ = record.steps;
    set_end(record.end, record.max_steps);
}

Summary Simulation::summary() const {
    Summary summary;
    summary.title = model().title;
    summary.state_hash = sim::state_hash(state_);
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
    for (std::string& line : StepWatch::totals(counts_, state_.step)) {
        summary.warnings.push_back(std::move(line));
    }
    summary.overrides = loaded_.overrides;
    return summary;
}

}  // namespace riprap::run
