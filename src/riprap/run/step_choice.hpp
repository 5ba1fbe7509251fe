// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/sim/advance.hpp"

namespace riprap::run {

// For every solid method: bodies have shapes, and State says how they move.

/// The step of sim::choose_time_step, an automatic one no longer than 0.2 r_min / (v_1 + v_2): speed against thickness,
/// wherever the two fastest bodies are, so that nothing passes unseen (solid::most_approach). In equal steps to the
/// end; a function of Model and State alone.
sim::TimeStep choose_step(const sim::Model& model, sim::State& state, sim::Scratch& scratch);

/// Why a step that the case fixes may not be taken: in it a body comes to another, on the line of its velocity, and
/// goes farther than the inscribed radius of one of them. Empty where it may, and where the step is automatic.
std::string step_problem(const sim::Model& model, const sim::State& state, double dt);

}  // namespace riprap::run
