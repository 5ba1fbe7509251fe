// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>

#include "riprap/core/parallel.hpp"

namespace riprap::run {

namespace {

std::string signal_name(int signal) {
    switch (signal) {
        case SIGINT:
            return "SIGINT";
        case SIGTERM:
            return "SIGTERM";
        case SIGHUP:
            return "SIGHUP";
        default:
            return fmt::format("signal {}", signal);
    }
}

/// Why a ledger ends the run; empty when it closes. Where hardly anything has turned over yet, round-off of the
/// energies that are there is all there is to see: a residual below 1e-9 of them says nothing. Nor do the first steps,
/// in which a contact that opens or closes between two kicks is not yet small beside what was turned over. Water is
/// resolved by its spacing: beside what was turned over stands what lifts all of it by one spacing, for when it is let
/// go its lattice settles by hundredths of that before anything flows.
std::string ledger_problem(const sim::Ledger& ledger, const sim::Model& model, std::int64_t step) {
    constexpr std::int64_t first_steps = 10;
    constexpr double round_off = 1e-9;
    const double tolerance = model.output.ledger_tolerance, residual = std::abs(ledger.residual);
    const double grain = model.fluid ? ledger.water.mass * norm(model.gravity.value) * model.fluid->sph.spacing : 0;
    const double counted = std::max(ledger.turnover, grain);
    const double scale = std::max({std::abs(ledger.kinetic), std::abs(ledger.potential), ledger.turnover});
    if (!ledger.has_energy || step <= first_steps || ledger.turnover <= 0 || residual <= round_off * scale ||
        residual <= tolerance * counted) {
        return "";
    }
    return fmt::format(
        "the energy ledger misses {:.3g} J of {:.3g} J that count as turned over at t = {:.6g} s, more than "
        "output.ledger_tolerance = {:.3g} of it",
        ledger.residual, counted, ledger.time, tolerance);
}

}  // namespace

Driver::Driver(RunFolder folder, scene::LoadedCase loaded, bool is_quiet)
    : folder_(std::move(folder)),
      loaded_(std::move(loaded)),
      is_quiet_(is_quiet),
      initial_(loaded_.state),
      bound_(sim::time_step_bound(loaded_.model)),
      watch_(loaded_.model) {
    sim::initialise(model(), initial_);
    state_ = initial_;
    set_end(model().time.end, model().time.max_steps);
    record_.frame_interval = frame_interval(model());
    record_.row_interval = row_interval(model());
}

void Driver::set_end(double end, std::int64_t max_steps) {
    record_.end = loaded_.model.time.end = end;
    record_.max_steps = max_steps;
    scratch_.forget();  // a step may be a share of the end
    next_ = choose_time_step(model(), state_, scratch_);
}

std::int64_t Driver::steps_left() const {
    return record_.max_steps >= 0 ? std::clamp<std::int64_t>(record_.max_steps - state_.step, 0, next_.steps_left)
                                  : next_.steps_left;
}

void Driver::store_case(const std::vector<std::string>& overrides) const {
    run::store_case(folder_, loaded_, overrides);
}

void Driver::start() {
    log_ = std::make_unique<RunLog>(folder_);
    announce("start");
    outputs_ = std::make_unique<Outputs>(folder_, model(), initial_, record_, false);
    watch_.look(now());
    outputs_->after_step(now(), outputs_->due_at(state_.time, 0));
    outputs_->note(record_);
    record_.expects = watch_.save();
    save_checkpoint(folder_, model(), state_, record_);
}

void Driver::resume(std::optional<double> end, std::optional<std::int64_t> max_steps) {
    Restart restart = load_checkpoint(folder_, model(), initial_);
    log_ = std::make_unique<RunLog>(folder_);
    if (!restart.notice.empty()) {
        log_->add("notice", restart.notice);
        say(restart.notice);
    }
    state_ = std::move(restart.state);
    record_ = std::move(restart.record);
    set_end(end.value_or(record_.end), max_steps.value_or(record_.max_steps));
    record_.resumes += 1;
    earlier_seconds_ = record_.wall_seconds;
    watch_.load(record_.expects);
    announce(fmt::format("resume at step {}", state_.step));
    if (steps_left() > 0) {
        outputs_ = std::make_unique<Outputs>(folder_, model(), initial_, record_, true);
    }
}

void Driver::announce(const std::string& beginning) {
    const std::int64_t steps = state_.step + steps_left();
    log_->add("start",
              fmt::format("{}: '{}', {} bodies, time step {:.6g} s, {} steps to t = {:.6g} s, {} threads", beginning,
                          model().title, model().bodies.size(), next_.dt, steps, record_.end, parallel::thread_count()),
              {{"step", static_cast<double>(state_.step)},
               {"steps", static_cast<double>(steps)},
               {"time_step", next_.dt},
               {"threads", parallel::thread_count()}});
    for (const std::string& warning : loaded_.warnings) {
        log_->add("warning", warning);
        say("warning: " + warning);
    }
    say(
        fmt::format("{}\n  {} bodies, {} convex parts, {} threads\n  time step {:.6g} s of at most {:.6g} s ({})\n"
                    "  {} steps to t = {:.6g} s, from step {}\n  writing to {}",
                    model().title.empty() ? "(untitled)" : model().title, model().bodies.size(),
                    model().bodies.part_count(), parallel::thread_count(), next_.dt, bound_.limit, bound_.reason, steps,
                    record_.end, state_.step, folder_.root.string()));
}

sim::StepReport Driver::take_step(Due& due) {
    const double dt = next_.dt, time = state_.time + dt;
    due = outputs_->due_at(time, dt);
    const bool is_last = steps_left() <= 1 || time + 1e-6 * dt >= record_.end;
    return advance(model(), state_, scratch_, dt, due.row || is_last ? sim::Measure::energy : sim::Measure::flow);
}

int Driver::run() {
    if (steps_left() == 0 && outputs_ == nullptr) {
        say(fmt::format(
            "nothing left to do: the run is at step {}, t = {:.6g} s; --end and --max-steps take it further",
            state_.step, state_.time));
        return verdict(watch_.judge(is_at_end()));
    }
    const StopRequest stop;
    Progress progress(state_.step, model().bodies.size(), is_quiet_);
    while (steps_left() > 0) {
        if (stop.signal() != 0) {
            return interrupt(progress, stop.signal());
        }
        good_.keep(state_);
        const std::int64_t step = state_.step;
        Due due;
        sim::StepReport report = take_step(due);
        const std::string problem = ledger_problem(report.ledger, model(), step + 1);
        if (!report.status.ok() || !problem.empty()) {
            state_ = good_.at(model(), step);
            if (!report.status.ok() && retry(report.status.text)) {
                continue;
            }
            return fail(progress, report.status.ok() ? problem : report.status.text);
        }
        report_ = std::move(report);
        has_stepped_ = true;
        next_ = choose_time_step(model(), state_, scratch_);
        watch_bound(report_);
        watch_.look(now());
        outputs_->after_step(now(), due);
        // The checkpoint of the last step is written by finish(), when everything else is: see there.
        const bool is_due = progress.seconds() - last_checkpoint_ >= model().output.checkpoint_interval;
        if (is_due && steps_left() > 0) {
            checkpoint(progress);
        }
        progress.show(state_.step, steps_left(), state_.time);
    }
    return finish(progress);
}

bool Driver::retry(const std::string& reason) {
    if (!halve_time_step(model(), state_)) {
        return false;
    }
    good_.replace(state_);
    scratch_.forget();  // it may hold what is not a number
    next_ = choose_time_step(model(), state_, scratch_);
    record_.retries += 1;
    const std::string text = fmt::format("step {} was refused and is taken again from t = {:.6g} s with {:.6g} s: {}",
                                         state_.step + 1, state_.time, next_.dt, reason);
    log_->add("retry", text,
              {{"step", static_cast<double>(state_.step)}, {"time", state_.time}, {"time_step", next_.dt}});
    say(text);
    return true;
}

/// Told when it happens first and whenever the excess has doubled; the summary counts all of them.
void Driver::watch_bound(const sim::StepReport& report) {
    if (!(report.dt > report.dt_bound)) {
        return;
    }
    record_.steps_above_bound += 1;
    const double excess = report.dt / report.dt_bound;
    if (excess < 2 * logged_excess_) {
        return;
    }
    logged_excess_ = excess;
    const std::string text = fmt::format(
        "step {}, t = {:.6g} s: the time step {:.4g} s is {:.3g} times what the contacts allow now ({:.4g} s, a bound "
        "that errs on the safe side); a smaller time_step, or time_step_factor, is safer",
        state_.step, state_.time, report.dt, excess, report.dt_bound);
    log_->add("warning", text,
              {{"step", static_cast<double>(state_.step)}, {"time", state_.time}, {"dt_bound", report.dt_bound}});
    say("warning: " + text);
}

void Driver::checkpoint(const Progress& progress) {
    outputs_->note(record_);
    record_.expects = watch_.save();
    record_.wall_seconds = earlier_seconds_ + progress.seconds();
    save_checkpoint(folder_, model(), state_, record_);
    last_checkpoint_ = progress.seconds();
    log_->add("checkpoint", fmt::format("step {}, t = {:.6g} s", state_.step, state_.time),
              {{"step", static_cast<double>(state_.step)},
               {"time", state_.time},
               {"ns_per_body_step", progress.cost(state_.step)}});
}

int Driver::finish(const Progress& progress) {
    Progress last_line = progress;
    last_line.finish(state_.step, steps_left(), state_.time);
    const std::vector<ExpectResult> results = watch_.judge(is_at_end());
    // The checkpoint comes last: killed before it, the run continues from the one before and writes all this again.
    outputs_->note(record_);
    outputs_->at_end(now());
    summarise(progress, "finished", is_at_end() ? "" : "max_steps reached", results);
    record_.expects = watch_.save();
    record_.wall_seconds = earlier_seconds_ + progress.seconds();
    save_checkpoint(folder_, model(), state_, record_);
    log_->add("end", fmt::format("finished at step {}, t = {:.6g} s", state_.step, state_.time),
              {{"step", static_cast<double>(state_.step)}, {"time", state_.time}});
    say(fmt::format("state hash {:016x}; energy ledger closes to {:.2g} J of {:.2g} J turned over",
                    sim::state_hash(state_), report_.ledger.residual, report_.ledger.turnover));
    return verdict(results);
}

int Driver::interrupt(const Progress& progress, int signal) {
    checkpoint(progress);
    const std::string reason = "stopped by " + signal_name(signal);
    summarise(progress, "interrupted", reason, watch_.judge(false));
    log_->add("end", reason, {{"step", static_cast<double>(state_.step)}, {"time", state_.time}});
    fmt::print(stderr, "\nriprap: {} at step {}, t = {:.6g} s; continue with `riprap resume {}`\n", reason, state_.step,
               state_.time, folder_.root.string());
    return static_cast<int>(ExitCode::signal_base) + signal;
}

int Driver::fail(const Progress& progress, const std::string& reason) {
    checkpoint(progress);
    summarise(progress, "failed", reason, watch_.judge(false));
    log_->add("end", "failed: " + reason, {{"step", static_cast<double>(state_.step)}, {"time", state_.time}});
    fmt::print(stderr,
               "\nriprap: step {} was refused: {}\n  the last good state (step {}, t = {:.6g} s) is in {}\n"
               "  {}\n",
               state_.step + 1, reason, state_.step, state_.time, folder_.checkpoint_latest().string(),
               model().fluid ? "water that leaves the domain needs a wall there; else a smaller fluid.courant or "
                               "fluid.spacing usually helps"
                             : "a smaller time_step, a stiffer material or more damping usually helps");
    return static_cast<int>(ExitCode::numerical);
}

int Driver::verdict(const std::vector<ExpectResult>& results) const {
    const std::string table = verdict_table(results);
    if (!table.empty()) {
        fmt::print("{}", table);
    }
    std::fflush(stdout);
    const bool has_failed = std::any_of(results.begin(), results.end(),
                                        [](const ExpectResult& result) { return result.verdict == Verdict::failed; });
    return static_cast<int>(has_failed ? ExitCode::failed : ExitCode::success);
}

void Driver::summarise(const Progress& progress, const std::string& status, const std::string& reason,
                       const std::vector<ExpectResult>& results) const {
    write_summary(folder_, {.status = status,
                            .reason = reason,
                            .title = model().title,
                            .state_hash = sim::state_hash(state_),
                            .steps = state_.step,
                            .time = state_.time,
                            .dt = state_.previous_dt,
                            .retries = record_.retries,
                            .steps_above_bound = record_.steps_above_bound,
                            .wall_seconds = earlier_seconds_ + progress.seconds(),
                            .cost = progress.cost(state_.step),
                            .body_count = model().bodies.size(),
                            .memory_bytes = has_stepped_ ? sim::memory_bytes(model(), state_, scratch_) : 0,
                            .threads = parallel::thread_count(),
                            .resumes = record_.resumes,
                            .ledger = report_.ledger,
                            .stages = sim::stage_times(scratch_),
                            .expects = results});
}

void Driver::say(const std::string& text) const {
    if (!is_quiet_) {
        fmt::print("{}\n", text);
        std::fflush(stdout);
    }
}

}  // namespace riprap::run
