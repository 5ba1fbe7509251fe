// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pieces of a step of the solids: for the sources of this folder only.

#include <functional>

#include "riprap/sim/step_context.hpp"

namespace riprap::sim {

/// Fields that a refused piece of the solids, or one on trial, may have changed.
struct Kept {
    body::BodyState bodies;
    contact::ContactHistory contacts;
    SolidFields fields;
    double previous_dt;
};
Kept keep(const State& state);
void take_back(Kept&& kept, State& state);

/// A piece of motion of the solids.
struct Piece {
    TimeSpan span;
    body::LoadView loads;  ///< held over it
    Measure measure;
};

/// Moves the solids over a piece; what is refused is taken back and cut finer where the method says that this helps.
/// @param take  called with the report of every part that counts, in their order
Outcome move_over(StepContext& step, const Piece& piece, const std::function<void(const solid::SolidReport&)>& take);

}  // namespace riprap::sim
