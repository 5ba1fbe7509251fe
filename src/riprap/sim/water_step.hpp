// SPDX-License-Identifier: Apache-2.0
#pragma once

// The fluid's side of one step: for the sources of this folder only.

#include <string>

#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"
#include "riprap/sim/water_scratch.hpp"

namespace riprap::sim {

/// What the water's step brings.
struct WaterReport {
    fluid::FluidReport fluid;
    double absorbed{0};      ///< by sponges, in this step [J]
    double flow_work{0};     ///< on the layers of inflows and outflows, likewise [J]
    double work_on_free{0};  ///< on free bodies, as the water sees it, in this step [J]
    int passes{0};           ///< force passes, more than one where light bodies feed back
    double residual{0};      ///< of the added-mass iteration, over |a| + |g| [-]
    bool is_settled{true};   ///< of that iteration
    std::string intruder;    ///< a moving body among the layers of an opening, and which; empty = none
    bool ok() const { return fluid.problem.empty(); }
};

/// Water from t_n to the kick and over it: density, half a drift, forces with bodies where they will be at mid-step.
/// Bodies are not moved. `scratch.loads`, `force` and `torque` are then what the solids feel over the step. After it,
/// end_water_step is due.
WaterReport kick_water(const Model& model, State& state, WaterScratch& scratch, double dt);

/// Ends the step of the water, `water` being what kick_water found: the second half of the drift, and what passes
/// inflows and outflows.
fluid::Passage end_water_step(const Model& model, State& state, const fluid::FluidReport& water, WaterScratch& scratch,
                              double dt);

/// Notes how bodies sped up over the step that took them from `before` to where they are: the first guess of the next.
void note_accelerations(const Model& model, const body::BodyState& before, State& state, const WaterScratch& scratch,
                        double dt);

/// The work that loads held over a step did on free bodies that went from `before` to where they are [J].
double work_done(const Model& model, const body::BodyState& before, const State& state, const WaterScratch& scratch);

/// Empties what a fresh State keeps for the coupling.
void reset(const Model& model, CouplingState& coupling);

}  // namespace riprap::sim
