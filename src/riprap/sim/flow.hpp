// SPDX-License-Identifier: Apache-2.0
#pragma once

// The fluid in a step, whatever its method: for the sources of this folder only.

#include "riprap/sim/step_context.hpp"

namespace riprap::sim {

/// Begins a step of the fluid: nothing where there is none. Refuses a step that the case fixes and the fluid does not
/// allow.
Outcome begin_flow(StepContext& step);

/// Takes the fluid over span k, to its loads on bodies where they were predicted to be and its kick. Its last span is
/// ended by `book`.
Outcome flow(StepContext& step, std::int64_t k);

/// Ends the last span of the fluid, with bodies at the end of the step, and books what both sides exchanged.
Outcome book(StepContext& step);

}  // namespace riprap::sim
