// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/sim/advance.hpp"

namespace riprap::run {

/// Counts of the steps of a run, over all processes that ran it.
struct StepCounts {
    std::int64_t above_bound{0};         ///< longer than what the contacts, or the water, allowed
    std::int64_t unsettled{0};           ///< in which the added-mass iteration ended for want of passes
    std::int64_t with_open_friction{0};  ///< in which friction of contacts was still changing as their iteration ended
    std::int64_t open_frictions{0};      ///< such contacts, all steps
    std::int64_t with_intruder{0};       ///< with a moving body behind an opening
    std::int64_t through_walls{0};       ///< particles of water that went through bodies, all steps
    std::int64_t renewals{0};            ///< of the geometry of water with two clocks, all steps
    std::int64_t solver_iterations{0};   ///< of the water's pressure equation, all steps
    std::int64_t most_iterations{0};     ///< in one step
    double worst_residual{0};            ///< of that equation over its right-hand side [-]
    double longest{0};                   ///< [s]
    double shortest{0};                  ///< that which meets the end not counted; 0 before there is one [s]

    void add(const sim::StepReport& report, bool meets_end);
    /// Sound steps to a flow step, in the mean: 1 with one clock [-].
    double sound_steps(std::int64_t steps) const {
        return renewals > 0 ? static_cast<double>(steps) / static_cast<double>(renewals) : 1;
    }

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("run.steps_above_bound", self.above_bound);
        visit("run.steps_unsettled", self.unsettled);
        visit("run.steps_with_open_friction", self.with_open_friction);
        visit("run.open_frictions", self.open_frictions);
        visit("run.steps_with_intruder", self.with_intruder);
        visit("run.water_through_walls", self.through_walls);
        visit("run.renewals", self.renewals);
        visit("run.solver_iterations", self.solver_iterations);
        visit("run.most_iterations", self.most_iterations);
        visit("run.worst_residual", self.worst_residual);
        visit("run.longest_step", self.longest);
        visit("run.shortest_step", self.shortest);
    }
};

/// A warning about a step that was accepted all the same.
struct Notice {
    std::string text;
    std::string_view number_name;  ///< of the number that goes with it
    double number{0};
};

/// Looks at every step for what does not end a run but must not pass in silence. It is told when it is counted first,
/// a step that is too long again whenever its excess has doubled.
class StepWatch {
 public:
    /// Returns warnings about the last step, which is in `counts`.
    std::vector<Notice> look(const sim::StepReport& report, const sim::State& state, const StepCounts& counts);

    /// The counts in words, for the end of the run; empty where there is nothing to tell.
    static std::vector<std::string> totals(const StepCounts& counts, std::int64_t steps);

    /// Largest step over its bound that was told [-]: part of a checkpoint, or it would be told again.
    double told_excess() const { return told_excess_; }
    void restore(double told_excess) { told_excess_ = told_excess; }

 private:
    void look_at_length(const sim::StepReport& report, const std::string& when, std::vector<Notice>& notices);

    double told_excess_{0};
};

}  // namespace riprap::run
