// SPDX-License-Identifier: Apache-2.0
#pragma once

// The fluid in a step, whatever its method: for the sources of this folder only.

#include <vector>

#include "riprap/sim/bound_methods.hpp"
#include "riprap/sim/cycle.hpp"
#include "riprap/sim/fluid_exchange.hpp"

namespace riprap::sim {

/// The spans of the fluid, to the loads that the solids feel over the step. The last span is not ended yet.
Outcome flow_over(const Model& model, State& state, Fluid& fluid, Solid& solids, const Cycle& cycle, ScratchData& data,
                  std::vector<FluidSpan>& spans, StepReport& report);

/// Books what both sides exchanged, and ends the last span of the fluid.
Outcome end_flow(const Model& model, State& state, Fluid& fluid, const Cycle& cycle, ScratchData& data,
                 std::vector<FluidSpan>& spans, StepReport& report);

}  // namespace riprap::sim
