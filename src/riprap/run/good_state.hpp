// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "riprap/run/step_watch.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {

/// Point that a run had reached, with all that has been counted of it.
struct Standing {
    sim::State state;
    std::vector<double> expects;  ///< of ExpectWatch::save
    StepCounts counts;
};

/// The last Standing that was judged and found good. The State before a step refused since then is computed again from
/// it: a fresh Scratch gives the same bits, so copying every step is not needed.
class GoodState {
 public:
    /// Steps from one judgement to the next, at most.
    static constexpr std::int64_t most_steps = 128;

    bool is_there() const { return standing_.has_value(); }
    bool is_due_after(std::int64_t step) const { return !standing_ || step >= standing_->state.step + most_steps; }
    void keep(Standing standing) { standing_ = std::move(standing); }
    void forget() { standing_.reset(); }
    const Standing& last() const { return *standing_; }
    /// The State before the step that was refused, which is the one after `step` steps.
    sim::State at(const sim::Model& model, std::int64_t step) const;

 private:
    std::optional<Standing> standing_;
};

}  // namespace riprap::run
