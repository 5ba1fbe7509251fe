// SPDX-License-Identifier: Apache-2.0
#pragma once

// The loop around sim::advance: outputs, checkpoints, progress, stop signals, refused steps, verdicts.

#include <memory>
#include <optional>

#include "riprap/run/expects.hpp"
#include "riprap/run/good_state.hpp"
#include "riprap/run/outputs.hpp"
#include "riprap/run/progress.hpp"
#include "riprap/run/restart.hpp"
#include "riprap/run/run_folder.hpp"
#include "riprap/run/run_log.hpp"
#include "riprap/run/signals.hpp"
#include "riprap/run/summary.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {

/// One run. Made, then started or resumed, then run.
class Driver {
 public:
    /// Prepares a case; touches no file. @throws CaseError
    Driver(RunFolder folder, scene::LoadedCase loaded, bool is_quiet);

    void store_case(const std::vector<std::string>& overrides) const;
    /// Begins at time 0: first frame, first rows, first checkpoint.
    void start();
    /// Continues from the checkpoint, with another end where one is given. @throws CheckpointError
    void resume(std::optional<double> end, std::optional<std::int64_t> max_steps);
    /// Steps to the end. @returns the exit code
    int run();

 private:
    void set_end(double end, std::int64_t max_steps);
    sim::StepReport take_step(Due& due);
    bool retry(const std::string& reason);
    void watch_bound(const sim::StepReport& report);
    int finish(const Progress& progress);
    int interrupt(const Progress& progress, int signal);
    int fail(const Progress& progress, const std::string& reason);
    int verdict(const std::vector<ExpectResult>& results) const;
    void checkpoint(const Progress& progress);
    void announce(const std::string& beginning);
    void summarise(const Progress& progress, const std::string& status, const std::string& reason,
                   const std::vector<ExpectResult>& results) const;
    bool is_at_end() const { return next_.steps_left == 0; }
    std::int64_t steps_left() const;
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
    sim::TimeStep next_;  ///< the step to take from state_
    sim::StepReport report_;
    bool has_stepped_{false};
    RunRecord record_;
    double earlier_seconds_{0};
    double last_checkpoint_{0};  ///< [s] of the progress timer
    double logged_excess_{0};    ///< largest dt / dt_bound that was told [-]
    ExpectWatch watch_;
    GoodState good_;
    std::unique_ptr<Outputs> outputs_;
    std::unique_ptr<RunLog> log_;
};

}  // namespace riprap::run
