// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/drive/driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>

#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/core/tint.hpp"
#include "riprap/io/output/output_kinds.hpp"
#include "riprap/run/check/check_case.hpp"
#include "riprap/run/drive/signals.hpp"
#include "riprap/run/simulate/state_hash.hpp"
#include "riprap/sim/method_traits.hpp"

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

/// "1 thread", "2 threads".
std::string counted(std::int64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}
std::string counted_bodies(std::int64_t count) { return fmt::format("{} {}", count, count == 1 ? "body" : "bodies"); }

/// Refuses an end before the time that the run has reached.
void refuse_earlier_end(double end, const sim::State& reached, const RunFolder& folder) {
    constexpr double slack = 1e-9;  // of the time: the last step may miss the end by round-off
    // With a `time_step` of the case the last step may go beyond the end.
    if (end < (1 - slack) * (reached.time - reached.previous_dt)) {
        Diagnostic problem;
        problem.place.file = folder.root.string();
        problem.message = fmt::format("the run is at t = {:.6g} s (step {}) already, beyond the end {:.6g} s",
                                      reached.time, reached.step, end);
        problem.allowed = "a later end, or a new run";
        throw CaseError(std::move(problem));
    }
}

/// Shows how far bodies have settled before time 0; null where a run says nothing.
SettleWatch settle_line(Voice voice) {
    if (voice != Voice::all) {
        return {};
    }
    auto line = std::make_shared<std::optional<Progress>>();
    return [line](std::int64_t step, double time, double end) {
        const Stand now{step, time, end};
        if (!*line) {
            line->emplace(Stand{0, 0, end}, CostUnit{}, "settling ", false);
        }
        if (time < end) {
            (*line)->show(now);
        } else {
            (*line)->finish(now);
        }
    };
}

}  // namespace

Driver::Driver(RunFolder folder, scene::LoadedCase loaded, Voice voice)
    : folder_(std::move(folder)), voice_(voice), simulation_(std::move(loaded), settle_line(voice)) {
    record_.frame_interval = frame_interval(model());
    record_.row_interval = row_interval(model());
}

void Driver::store_case(const std::vector<std::string>& overrides) const {
    run::store_case(folder_, simulation_.loaded(), overrides);
}

void Driver::start(std::optional<double> end, std::optional<std::int64_t> max_steps) {
    if (end || max_steps) {
        refuse_earlier_end(end.value_or(model().time.end), state(), folder_);
        simulation_.set_end(end.value_or(model().time.end), max_steps.value_or(model().time.max_steps));
    }
    log_ = std::make_unique<RunLog>(folder_);
    announce("start");
    outputs_ = std::make_unique<Outputs>(folder_, simulation_.loaded(), simulation_.initial(), record_, false);
    outputs_->after_step(simulation_.now(), outputs_->due_at(state().time, 0));
    outputs_->note(record_);
    simulation_.note(record_);
    save_checkpoint(folder_, model(), state(), record_);
    record_.good = {};  // a whole State, which the next one brings along
}

void Driver::resume(std::optional<double> end, std::optional<std::int64_t> max_steps) {
    Restart restart = load_checkpoint(folder_, model(), simulation_.initial());
    refuse_earlier_end(end.value_or(restart.record.end), restart.state, folder_);
    take_up(std::move(restart), end, max_steps);
}

void Driver::resume_case() {
    const sim::TimeSettings time = model().time;
    Restart restart = load_checkpoint(folder_, model(), simulation_.initial());
    if (restart.is_of_unknown_case) {
        throw CheckpointError(fmt::format(
            "the checkpoint in {0} is of an older Riprap, which cannot tell whether it belongs to this case: continue "
            "the case that was stored with it by riprap resume {0}, or begin anew with --force",
            folder_.root.string()));
    }
    const double end = std::max(time.end, restart.state.time);  // `resume --end` may have taken it further
    take_up(std::move(restart), end, time.max_steps);
}

void Driver::take_up(Restart restart, std::optional<double> end, std::optional<std::int64_t> max_steps) {
    log_ = std::make_unique<RunLog>(folder_);
    if (restart.is_of_older_version) {
        for (const std::filesystem::path& table : io::set_older_tables_aside(
                 *simulation_.loaded().outputs, folder_.root, model(), restart.record.csv_bytes)) {
            restart.notice += fmt::format("; '{}' has the rows before, with other columns", table.string());
        }
    }
    if (!restart.notice.empty()) {
        log_->add("notice", restart.notice);
        fmt::print(stderr, "riprap: {}\n", printable(restart.notice));  // steps are lost: told under --quiet too
    }
    record_ = std::move(restart.record);
    record_.end = end.value_or(record_.end);
    record_.max_steps = max_steps.value_or(record_.max_steps);
    record_.resumes += 1;
    simulation_.restore(std::move(restart.state), record_);
    step_watch_.restore(record_.told_excess);
    earlier_seconds_ = record_.wall_seconds;
    announce(fmt::format("resume at step {}", state().step));
    if (simulation_.steps_left() > 0) {
        outputs_ = std::make_unique<Outputs>(folder_, simulation_.loaded(), simulation_.initial(), record_, true);
        if (restart.is_of_older_version) {
            outputs_->note(record_);
            save_checkpoint(folder_, model(), state(), record_);
        }
    } else {  // answers come from the checkpoint, but tables are read by others
        io::require_tables(*simulation_.loaded().outputs, folder_.root, model(), record_.csv_bytes);
    }
}

void Driver::announce(const std::string& beginning) {
    const std::int64_t steps = state().step + simulation_.steps_left();
    log_->add("start",
              fmt::format("{}: '{}', {} bodies, time step {:.6g} s, {} steps to t = {:.6g} s, {}", beginning,
                          model().title, model().bodies.size(), simulation_.next_dt(), steps, simulation_.end(),
                          counted(parallel::thread_count(), "thread")),
              {{"step", static_cast<double>(state().step)},
               {"steps", static_cast<double>(steps)},
               {"time_step", simulation_.next_dt()},
               {"threads", parallel::thread_count()}});
    for (const std::string& warning : simulation_.loaded().warnings) {
        warn(warning);
    }
    const sim::TimeStepBound limit = simulation_.step_bound();
    std::string sides;
    for (const std::string& side : sim::absorbed_ranges(model())) {
        sides += fmt::format("  {}\n", side);
    }
    say(
        fmt::format("{}\n  {}, {}, {}\n{}  time step {:.6g} s, at most {:.6g} s ({})\n"
                    "  {} steps to t = {:.6g} s, from step {}\n  writing to {}",
                    model().title.empty() ? "(untitled)" : model().title, counted_bodies(model().bodies.size()),
                    counted(model().bodies.part_count(), "convex part"), counted(parallel::thread_count(), "thread"),
                    water_text() + sides, simulation_.next_dt(), limit.limit, limit.reason, steps, simulation_.end(),
                    state().step, folder_.root.string()));
}

/// The line of the beginning that is about water, where there is any.
std::string Driver::water_text() const {
    if (model().particles() == nullptr) {
        return {};
    }
    std::string text = fmt::format("  {} particles of water", state().fluid.size());
    if (const sim::TimeStepBound& solids = simulation_.bound(); std::isfinite(solids.limit)) {
        text += fmt::format("; bodies take steps of their own within its steps, of {:.6g} s or less ({})",
                            sim::largest_time_step(model(), solids), solids.reason);
    }
    return text + '\n';
}

StepOutcome Driver::take_step(Due& due) {
    const double dt = simulation_.next_dt();
    due = outputs_->due_at(state().time + dt, dt);
    const bool is_record = due.row || due.frame;
    return simulation_.step(is_record || simulation_.next_is_last() ? sim::Measure::energy : sim::Measure::flow,
                            is_record ? Use::record : Use::look);
}

int Driver::run(const Watch& watch) {
    if (simulation_.steps_left() == 0 && outputs_ == nullptr) {
        const std::int64_t most = model().time.max_steps;
        say(fmt::format("nothing left to do: the run is at step {}, t = {:.6g} s; {}", state().step, state().time,
                        most >= 0 && state().step >= most
                            ? fmt::format("max_steps = {} holds it there, --max-steps -1 lifts it", most)
                            : "--end takes it further"));
        if (const std::filesystem::path mended = io::mend_bodies(folder_.root, simulation_.now()); !mended.empty()) {
            say(fmt::format("'{}' was missing or cut and is written again, without the forces of contacts",
                            mended.string()));
        }
        return verdict(simulation_.judge());
    }
    const StopRequest stop;
    Progress progress(stand(), cost_unit(), "", voice_ != Voice::all);
    while (simulation_.steps_left() > 0) {
        if (stop.signal() != 0) {
            return interrupt(progress, "stopped by " + signal_name(stop.signal()),
                             static_cast<int>(ExitCode::signal_base) + stop.signal());
        }
        Due due;
        const StepOutcome outcome = take_step(due);
        if (outcome.kind == StepOutcome::Kind::refused) {
            return fail(progress, outcome);
        }
        if (outcome.kind == StepOutcome::Kind::retried) {
            tell_retry(outcome);
            continue;
        }
        tell_notices();
        outputs_->after_step(simulation_.now(), due);
        // The checkpoint of the last step is written by finish(), when everything else is: see there.
        const bool is_due = progress.seconds() - last_checkpoint_ >= model().output.checkpoint_interval;
        if (is_due && simulation_.steps_left() > 0) {
            checkpoint(progress);
        }
        progress.show(stand());
        if (watch && !watch(simulation_) && simulation_.steps_left() > 0) {
            return interrupt(progress, "stopped by its watcher", static_cast<int>(ExitCode::success));
        }
    }
    return finish(progress);
}

void Driver::tell_retry(const StepOutcome& outcome) {
    const std::string text = fmt::format("step {} was refused and is taken again from t = {:.6g} s with {:.6g} s: {}",
                                         state().step + 1, state().time, simulation_.next_dt(), outcome.why.text);
    log_->add(
        "retry", text,
        {{"step", static_cast<double>(state().step)}, {"time", state().time}, {"time_step", simulation_.next_dt()}});
    say(text);
}

void Driver::warn(const std::string& text, RunLog::Numbers numbers) {
    log_->add("warning", text, numbers);
    say(text, "warning: ");
}

/// Counts the warnings again at the end of the run: the first of them have long left the screen.
void Driver::tell_warnings() const {
    if (const std::size_t count = log_->warnings().size(); count > 0) {
        say(fmt::format("{} warning{} of this run {} in {}", count, count == 1 ? "" : "s", count == 1 ? "is" : "are",
                        folder_.summary().string()));
    }
}

void Driver::tell_notices() {
    for (const Notice& notice : step_watch_.look(simulation_.report(), state(), simulation_.counts())) {
        warn(
            notice.text,
            {{"step", static_cast<double>(state().step)}, {"time", state().time}, {notice.number_name, notice.number}});
    }
}

Stand Driver::stand() const { return {state().step, state().time, simulation_.end(), model().time.max_steps}; }

CostUnit Driver::cost_unit() const {
    if (state().fluid.size() > 0) {
        return {"particle", state().fluid.size()};
    }
    return model().has_fluid() || model().bodies.size() == 0 ? CostUnit{} : CostUnit{"body", model().bodies.size()};
}

double Driver::cost_per_body(const Progress& progress) const {
    return 1e9 * progress.pace().seconds_per_step() / std::max(1, model().bodies.size());
}

double Driver::predicted_seconds(const Progress& progress) const {
    const double left = progress.pace().seconds_to_end();
    return earlier_seconds_ + progress.seconds() + (std::isfinite(left) ? left : 0);
}

/// For a run that max_steps has stopped: a few steps tell what the whole would take.
void Driver::tell_prediction(const Progress& progress) {
    const double step_seconds = progress.pace().seconds_per_step(), total = predicted_seconds(progress);
    const std::int64_t particles = state().fluid.size();
    const std::string text = fmt::format(
        "stopped by max_steps: {:.4g} ms per step{}; predicted total {} to t = {:.6g} s with {}, at this pace",
        1e3 * step_seconds, particles > 0 ? fmt::format(" with {} particles of water", particles) : std::string(),
        duration_text(total), simulation_.end(), counted(parallel::thread_count(), "thread"));
    log_->add("prediction", text, {{"seconds_per_step", step_seconds}, {"seconds", total}});
    say(text);
}

void Driver::note(const Progress& progress) {
    simulation_.note(record_);
    record_.told_excess = step_watch_.told_excess();
    record_.wall_seconds = earlier_seconds_ + progress.seconds();
}

void Driver::checkpoint(const Progress& progress) {
    outputs_->note(record_);
    note(progress);
    save_checkpoint(folder_, model(), state(), record_);
    record_.good = {};  // a whole State, which the next one brings along
    last_checkpoint_ = progress.seconds();
    log_->add("checkpoint", fmt::format("step {}, t = {:.6g} s", state().step, state().time),
              {{"step", static_cast<double>(state().step)},
               {"time", state().time},
               {"ns_per_body_step", cost_per_body(progress)},
               {"seconds_per_step", progress.pace().seconds_per_step()}});
}

int Driver::finish(const Progress& progress) {
    Progress last_line = progress;
    last_line.finish(stand());
    const std::vector<ExpectResult> results = simulation_.judge();
    // The checkpoint comes last: killed before it, the run continues from the one before and writes all this again.
    outputs_->note(record_);
    outputs_->at_end(simulation_.now());
    for (const std::string& line : simulation_.totals()) {
        warn(line);
    }
    const bool is_whole = simulation_.is_at_end();
    summarise(progress, is_whole ? "finished" : "interrupted", is_whole ? "" : "stopped by max_steps", results);
    note(progress);
    save_checkpoint(folder_, model(), state(), record_);
    record_.good = {};  // a whole State, which the next one brings along
    if (!is_whole && simulation_.has_stepped()) {
        tell_prediction(progress);
    }
    log_->add("end",
              fmt::format("{} at step {}, t = {:.6g} s", is_whole ? "finished" : "stopped by max_steps", state().step,
                          state().time),
              {{"step", static_cast<double>(state().step)}, {"time", state().time}});
    if (const StepCounts& counts = simulation_.counts(); counts.solver_iterations > 0) {
        const double mean = static_cast<double>(counts.solver_iterations) / static_cast<double>(state().step);
        const std::string text =
            fmt::format("pressure equation: {:.1f} iterations a step, {} at most, residual {:.2g} at most", mean,
                        counts.most_iterations, counts.worst_residual);
        log_->add("solver", text,
                  {{"iterations_mean", mean},
                   {"iterations_max", static_cast<double>(counts.most_iterations)},
                   {"residual_max", counts.worst_residual}});
        say(text);
    }
    const sim::Ledger& ledger = simulation_.report().ledger;
    const std::string unit = sim::unit_in("J", model().bodies.is_planar);
    say(fmt::format("state hash {:016x}; energy balance: residual {:.2g} {} of {:.2g} {} exchanged", xxh3_of(state()),
                    ledger.residual, unit, ledger.turnover, unit));
    tell_warnings();
    return verdict(results);
}

int Driver::interrupt(const Progress& progress, const std::string& reason, int code) {
    checkpoint(progress);
    summarise(progress, "interrupted", reason, simulation_.judge(false));
    log_->add("end", reason, {{"step", static_cast<double>(state().step)}, {"time", state().time}});
    if (code != 0 && voice_ != Voice::none) {
        fmt::print(stderr, "\nriprap: {} at step {}, t = {:.6g} s; continue with `riprap resume {}`\n", reason,
                   state().step, state().time, printable(folder_.root.string()));
    }
    return code;
}

int Driver::fail(const Progress& progress, const StepOutcome& refused) {
    checkpoint(progress);
    const std::string reason = refused.why.with_remedy();
    summarise(progress, "failed", reason, simulation_.judge(false));
    log_->add("end", "failed: " + reason, {{"step", static_cast<double>(state().step)}, {"time", state().time}});
    if (voice_ != Voice::none) {
        fmt::print(stderr, "\n{} step {} was refused: {}\n  the last good state (step {}, t = {:.6g} s) is in {}\n{}",
                   tinted("riprap:", Tint::bad, shows_colours(stderr)), state().step + 1, refused.why.text,
                   state().step, state().time, printable(folder_.checkpoint_latest().string()),
                   refused.why.remedy.empty() ? "" : fmt::format("  what helps: {}\n", refused.why.remedy));
    }
    return static_cast<int>(ExitCode::numerical);
}

int Driver::verdict(const std::vector<ExpectResult>& results) const {
    const std::string table = verdict_table(results, shows_colours(stdout));
    if (!table.empty() && voice_ != Voice::none) {
        fmt::print("{}", table);
    }
    std::fflush(stdout);
    const bool has_failed = std::any_of(results.begin(), results.end(),
                                        [](const ExpectResult& result) { return result.verdict == Verdict::failed; });
    return static_cast<int>(has_failed ? ExitCode::failed : ExitCode::success);
}

void Driver::summarise(const Progress& progress, const std::string& status, const std::string& reason,
                       const std::vector<ExpectResult>& results) const {
    Summary summary = simulation_.summary();
    summary.status = status;
    summary.reason = reason;
    summary.wall_seconds = earlier_seconds_ + progress.seconds();
    summary.predicted_seconds = predicted_seconds(progress);
    summary.seconds_per_step = progress.pace().seconds_per_step();
    summary.cost = cost_per_body(progress);
    summary.resumes = record_.resumes;
    summary.expects = results;
    summary.warnings = log_->warnings();
    write_summary(folder_, summary);
}

void Driver::say(const std::string& text, const std::string& caution) const {
    if (voice_ == Voice::all) {
        const std::string begin = caution.empty() ? "" : tinted(caution, Tint::caution, shows_colours(stdout));
        fmt::print("{}{}\n", begin, printable(text));
        std::fflush(stdout);
    }
}

}  // namespace riprap::run
