// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/sim/advance.hpp"

namespace riprap::run {

// For every solid method: bodies have shapes, and State says how they move.

/// The step of sim::choose_time_step, an automatic one no longer than 0.2 r_min / (v_1 + v_2): speed against thickness,
/// wherever the two fastest bodies are, so that nothing passes unseen (solid::most_approach); nor so long that a driven
/// body goes farther than 0.4 r_min, however its motion jumps. In equal steps to the end; a function of Model and State
/// alone.
sim::TimeStep choose_step(const sim::Model& model, sim::State& state, sim::Scratch& scratch);

/// Why a step may not be taken: in it a body goes through another, or deep into it, by more than the inscribed radius
/// of one of them (find_sweep). Empty where it may. An automatic step is refused for a motion that jumps only.
std::string step_problem(const sim::Model& model, const sim::State& state, double dt);

}  // namespace riprap::run
