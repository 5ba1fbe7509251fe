// SPDX-License-Identifier: Apache-2.0
#pragma once

// The loop around a Simulation: outputs, checkpoints, progress, stop signals, verdicts.

#include <memory>
#include <optional>

#include "riprap/run/drive/progress.hpp"
#include "riprap/run/drive/watch.hpp"
#include "riprap/run/folder/run_log.hpp"
#include "riprap/run/simulate/outputs.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/run/simulate/step_watch.hpp"

namespace riprap::run {

/// Amount of text that a run prints.
enum class Voice {
    all,
    verdicts,  ///< and errors
    none,
};

/// One run. Made, then started or resumed, then run.
class Driver {
 public:
    /// Prepares a case; touches no file. @throws CaseError
    Driver(RunFolder folder, scene::LoadedCase loaded, Voice voice);

    void store_case(const std::vector<std::string>& overrides) const;
    /// Begins at time 0, with another end where one is given: first frame, first rows, first checkpoint.
    void start(std::optional<double> end = {}, std::optional<std::int64_t> max_steps = {});
    /// Continues from the checkpoint, with another end where one is given. @throws CheckpointError
    void resume(std::optional<double> end, std::optional<std::int64_t> max_steps);
    /// Continues to the end that the case gives, if the run is not beyond that already. @throws CheckpointError
    void resume_case();
    /// Steps to the end, or until `watch` says stop. @returns the exit code
    int run(const Watch& watch = {});

 private:
    void take_up(Restart restart, std::optional<double> end, std::optional<std::int64_t> max_steps);
    StepOutcome take_step(Due& due);
    void tell_retry(const StepOutcome& outcome);
    void tell_notices();
    void warn(const std::string& text, RunLog::Numbers numbers = {});
    void tell_warnings() const;
    Stand stand() const;
    CostUnit cost_unit() const;
    double cost_per_body(const Progress& progress) const;  ///< [ns per body and step]
    void tell_prediction(const Progress& progress);
    /// Wall-clock time of the whole run, to its end whatever max_steps says, at the pace of this process so far [s].
    double predicted_seconds(const Progress& progress) const;
    int finish(const Progress& progress);
    int interrupt(const Progress& progress, const std::string& reason, int code);
    int fail(const Progress& progress, const StepOutcome& refused);
    int verdict(const std::vector<ExpectResult>& results) const;
    void note(const Progress& progress);
    void checkpoint(const Progress& progress);
    void announce(const std::string& beginning);
    std::string water_text() const;
    void summarise(const Progress& progress, const std::string& status, const std::string& reason,
                   const std::vector<ExpectResult>& results) const;
    const sim::Model& model() const { return simulation_.model(); }
    const sim::State& state() const { return simulation_.state(); }
    void say(const std::string& text, const std::string& caution = "") const;

    RunFolder folder_;
    Voice voice_;
    Simulation simulation_;
    RunRecord record_;
    double earlier_seconds_{0};
    double last_checkpoint_{0};  ///< [s] of the progress timer
    StepWatch step_watch_;
    std::unique_ptr<Outputs> outputs_;
    std::unique_ptr<RunLog> log_;
};

}  // namespace riprap::run
