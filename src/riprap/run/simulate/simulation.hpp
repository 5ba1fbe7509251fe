// SPDX-License-Identifier: Apache-2.0
#pragma once

// A case that is being stepped, in memory: what the command line's driver and the Python module have in common.

#include <string>

#include "riprap/run/figures/expects.hpp"
#include "riprap/run/simulate/good_state.hpp"
#include "riprap/run/simulate/passage_verdict.hpp"
#include "riprap/run/simulate/restart.hpp"
#include "riprap/run/simulate/settle.hpp"
#include "riprap/run/simulate/summary.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {

/// Result of one step.
struct StepOutcome {
    enum class Kind {
        accepted,
        retried,  ///< refused; the State is one before it, and the next step is half as long
        refused,  ///< for good: the State is the last good one
    };
    Kind kind{Kind::accepted};
    sim::StepStatus why{};  ///< of a refusal
    bool is_accepted() const { return kind == Kind::accepted; }
};

/// Use of the energies that a step measures beyond its turn.
enum class Use {
    record,  ///< a row or a frame of the case: the step is judged first, or what is written might be taken back
    look,    ///< whoever asked looks at them: where the run is judged does not move
};

/// Model and State of a case with all that a step needs to be chosen, taken, judged and, where it was refused, taken
/// back. Touches no file. The bits of the State depend on the case, its rows and frames and the number of steps alone,
/// not on who asks for them, in what portions, where max_steps or a signal stopped the run or with how many threads.
class Simulation {
 public:
    /// At time 0, after bodies have settled, of which `settling` is told. @throws CaseError
    explicit Simulation(scene::LoadedCase loaded, const SettleWatch& settling = {});
    Simulation(const Simulation&) = delete;  // who watches the expected answers keeps a reference to the Model
    Simulation& operator=(const Simulation&) = delete;
    ~Simulation() = default;

    const scene::LoadedCase& loaded() const { return loaded_; }
    const sim::Model& model() const { return loaded_.model; }
    const sim::State& initial() const { return initial_; }
    const sim::State& state() const { return state_; }
    /// The fields of the State as storage: who needs an array of them to outlive the next step takes it and puts a copy
    /// in its place. No value may change.
    sim::State& storage() { return state_; }
    /// The scene now, as quantities read it; with contacts and a report where has_stepped().
    sim::Moment now() const {
        return {model(), initial_, state_, has_stepped_ ? &scratch_ : nullptr, has_stepped_ ? &report_ : nullptr};
    }
    const sim::Scratch& scratch() const { return scratch_; }
    /// Of the last accepted step of this process.
    const sim::StepReport& report() const { return report_; }
    /// Contacts and forces of the last step are there: not at time 0, after a restart, a new end or a refused step.
    bool has_stepped() const { return has_stepped_; }
    const sim::TimeStepBound& bound() const { return bound_; }  ///< of the solids
    /// Of the run, now; and why a step that the case fixes cannot be taken from here, empty where it can.
    sim::TimeStepBound step_bound() { return sim::step_bound(model(), state_); }
    std::string fixed_step_problem() { return sim::fixed_step_problem(model(), state_); }

    /// End of the run: a time [s], and a number of steps in all (-1 = no limit). An automatic step is chosen so that
    /// the last one meets the end.
    void set_end(double end, std::int64_t max_steps);
    double end() const { return model().time.end; }
    std::int64_t max_steps() const { return model().time.max_steps; }
    std::int64_t steps_left() const;
    bool is_at_end() const { return next_.steps_left == 0; }  ///< in time; max_steps may stop it earlier
    const StepCounts& counts() const { return counts_; }
    double next_dt() const { return next_.dt; }  ///< of the step that comes next [s]
    bool next_is_last() const;                   ///< of this process: the end, or where max_steps stops it

    /// Takes one step; only where steps_left() > 0. Steps are judged in the first ten, with every record, at the end in
    /// time and every GoodState::most_steps. Where max_steps stops the run its State is looked at, and totals() tells
    /// what is wrong with it; it is judged when the run goes on.
    StepOutcome step(sim::Measure measure, Use use = Use::record);

    std::vector<ExpectResult> judge() const { return judge(is_at_end()); }
    std::vector<ExpectResult> judge(bool at_end) const { return watch_.judge(at_end); }

    /// Writes to and reads from a checkpoint all that it holds besides the State. @throws CheckpointError
    void note(RunRecord& record) const;
    void restore(sim::State state, const RunRecord& record);

    /// Returns the verdict on all steps together at the end of the run.
    std::vector<std::string> totals() const;
    /// All of a Summary that does not depend on files, clocks and restarts.
    Summary summary() const;

 private:
    void forget_scratch();
    /// Returns the fault of the scene after a step whose energy was measured; empty where there is none.
    std::string judge_step(const sim::StepReport& report) const;
    bool next_ends() const;  ///< in time
    /// Returns what a run that max_steps stops in a step that is not judged would have been judged by.
    std::string problem_at_stop(const sim::StepReport& report) const;
    void keep_standing();
    /// Goes back to a State and on from there with a shorter step, where one is left to try: never with the same again.
    /// @param report  of the step that was refused, with the reason
    StepOutcome take_back(sim::State to, const sim::StepReport& report);

    scene::LoadedCase loaded_;
    sim::State initial_, state_;
    sim::TimeStepBound bound_;
    sim::Scratch scratch_;
    sim::TimeStep next_;  ///< the step to take from state_
    sim::StepReport report_;
    bool has_stepped_{false};
    std::int64_t retries_{0};
    StepCounts counts_;
    ExpectWatch watch_;
    GoodState good_;
    PassageWatch passages_;
    std::string stop_problem_;  ///< of the last step, problem_at_stop
};

}  // namespace riprap::run
