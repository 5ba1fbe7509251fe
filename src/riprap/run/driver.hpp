// SPDX-License-Identifier: Apache-2.0
#pragma once

// The loop around sim::advance: outputs, checkpoints, progress, stop signals, bad states, verdicts.

#include <memory>
#include <optional>

#include "riprap/run/expects.hpp"
#include "riprap/run/outputs.hpp"
#include "riprap/run/progress.hpp"
#include "riprap/run/restart.hpp"
#include "riprap/run/run_folder.hpp"
#include "riprap/run/run_log.hpp"
#include "riprap/run/signals.hpp"
#include "riprap/run/summary.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {

/// A copy of State from a few steps ago. The last good State before a failed step is computed again from it: a
/// fresh Scratch gives the same bits, so copying every step is not needed.
class GoodState {
 public:
    void keep(const sim::State& state);
    /// The State at `step`, which is not before the last copy.
    sim::State at(const sim::Model& model, std::int64_t step, double dt) const;

 private:
    std::optional<sim::State> copy_;
};

/// One run. Made, then started or resumed, then run.
class Driver {
 public:
    /// Prepares a case; touches no file. @throws CaseError
    Driver(RunFolder folder, scene::LoadedCase loaded, bool is_quiet);

    void store_case(const std::vector<std::string>& overrides) const;
    /// Begins at time 0: first frame, first rows, first checkpoint.
    void start();
    /// Continues from the checkpoint. @throws CheckpointError
    void resume(std::optional<double> end, std::optional<std::int64_t> max_steps);
    /// Steps to the end. @returns the exit code
    int run();

 private:
    int finish(const Progress& progress);
    int interrupt(const Progress& progress, int signal);
    int fail(const Progress& progress, std::int64_t step, const std::string& reason);
    int verdict(const std::vector<ExpectResult>& results) const;
    void checkpoint(const Progress& progress);
    void announce(const std::string& beginning);
    void summarise(const Progress& progress, const std::string& status, const std::string& reason,
                   const std::vector<ExpectResult>& results) const;
    bool is_at_end() const { return state_.step >= count_steps(record_.end, record_.dt, -1); }
    std::int64_t last_step() const { return count_steps(record_.end, record_.dt, record_.max_steps); }
    sim::Moment now() const {
        return {model(), initial_, state_, has_stepped_ ? &scratch_ : nullptr, has_stepped_ ? &report_ : nullptr};
    }
    const sim::Model& model() const { return loaded_.model; }
    void say(const std::string& text) const;

    RunFolder folder_;
    scene::LoadedCase loaded_;
    bool is_quiet_;
    sim::State initial_, state_;
    sim::TimeStepBound bound_;
    sim::Scratch scratch_;
    sim::StepReport report_;
    bool has_stepped_{false};
    RunRecord record_;
    double earlier_seconds_{0};
    double last_checkpoint_{0};  ///< [s] of the progress timer
    ExpectWatch watch_;
    GoodState good_;
    std::unique_ptr<Outputs> outputs_;
    std::unique_ptr<RunLog> log_;
};

}  // namespace riprap::run
