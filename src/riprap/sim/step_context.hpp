// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the functions of a step share: for the sources of this folder only.

#include <vector>

#include "riprap/coupling/fluid_step.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/bound_methods.hpp"
#include "riprap/sim/cycle.hpp"
#include "riprap/sim/ledger_account.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/scratch_data.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::sim {

/// Result of one span of the fluid.
struct FluidSpan {
    coupling::FluidStep step;
    double work_on_free{0};  ///< on free bodies, as the fluid sees it [J]
};

/// One step: who moves what, how the time is shared out between both sides, and what is found on the way. Made anew
/// each step; Model, State and Scratch outlive it.
struct StepContext {
    const Model& model;
    State& state;
    ScratchData& scratch;
    solid::SolidMethod& solid;
    coupling::FluidMethod& fluid;
    bool fluid_leads;  ///< it moves by itself
    Measure measure;   ///< of the last piece of the solids
    Accounts accounts;
    Cycle cycle;                   ///< without a span where there is no fluid
    StepLimit fluid_limit;         ///< where it is of a meaning, see make_cycle
    body::LoadView loads;          ///< on bodies, held over the step: given to it, or those of the fluid
    std::vector<FluidSpan> spans;  ///< of the fluid, so far
    StepReport report;
};

/// Begins a step of `dt` [s] from the State as it is. @param loads  on the bodies, where there is no fluid
StepContext begin_step(const Model& model, State& state, ScratchData& scratch, BoundMethods& bound, double dt,
                       Measure measure, const body::LoadView& loads);

}  // namespace riprap::sim
