// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a Scratch holds: for the sources of this folder only.

#include <optional>

#include "riprap/contact/pipeline.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/body/point_loads.hpp"
#include "riprap/sim/water_step.hpp"

namespace riprap::sim {

struct ScratchData {
    contact::ContactPipeline pipeline;
    body::Loads loads;
    body::BodyKinematics kinematics;
    body::PointLoadSum point_loads;
    WaterScratch water;
    body::BodyState before;  ///< bodies at the start of the step, where there is water
    StageTimes times;
    std::optional<double> largest_time_step;  ///< of the solids [s]; set when it is first asked for
};

/// Steps of the solids within one of the water that lasts `dt`, from their own bound.
std::int64_t solid_substeps(const Model& model, const State& state, ScratchData& scratch, double dt);

}  // namespace riprap::sim
