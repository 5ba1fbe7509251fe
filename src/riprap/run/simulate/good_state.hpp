// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "riprap/run/simulate/step_watch.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {

/// Point that a run had reached, with all that has been counted of it.
struct Standing {
    sim::State state;
    std::vector<double> expects;  ///< of ExpectWatch::save
    StepCounts counts;

    /// What is counted. The State has a list of its own.
    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("run.expects", self.expects);
        StepCounts::visit_fields(self.counts, visit);
    }
};

/// The last Standing that was judged and found good, and the steps taken since. The State before a step refused since
/// then is computed again from them: a fresh Scratch gives the same bits, so copying every step is not needed. Part of
/// a checkpoint: where a run goes back to must not depend on where it was stopped.
class GoodState {
 public:
    /// Steps from one judgement to the next, at most.
    static constexpr std::int64_t most_steps = 128;

    bool is_there() const { return standing_ != nullptr; }
    bool is_due_after(std::int64_t step) const { return !is_there() || step >= last().state.step + most_steps; }
    /// Takes the place where the run is.
    void keep(Standing standing);
    /// Takes the Standing of a checkpoint, from which the steps were read already.
    void put_back(Standing standing) { standing_ = std::make_shared<const Standing>(std::move(standing)); }
    /// The run is at the last Standing again.
    void go_back() { steps_.clear(); }
    void add_step(double dt) { steps_.push_back(dt); }
    const Standing& last() const { return *standing_; }
    /// Lengths of the steps taken since the last Standing [s]; none where the run is there.
    const std::vector<double>& steps() const { return steps_; }
    /// The State that these steps lead to: for one that is not good any more.
    sim::State now(const sim::Model& model) const;

    /// The steps. The Standing has a list of its own.
    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("run.steps_since_judged", self.steps_);
    }

 private:
    std::shared_ptr<const Standing> standing_;  ///< shared with records of the run
    std::vector<double> steps_;
};

}  // namespace riprap::run
