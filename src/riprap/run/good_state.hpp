// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "riprap/sim/advance.hpp"

namespace riprap::run {

/// A copy of State from a few steps ago. The last good State before a refused step is computed again from it: a
/// fresh Scratch gives the same bits, so copying every step is not needed.
class GoodState {
 public:
    /// Called before every step; copies the State now and then.
    void keep(const sim::State& state);
    /// The State at hand was changed from outside: steps are computed again from here on.
    void replace(const sim::State& state) { copy_ = state; }
    /// The State before the step that was refused, which is the one after `step` steps.
    sim::State at(const sim::Model& model, std::int64_t step) const;

 private:
    std::optional<sim::State> copy_;
};

}  // namespace riprap::run
