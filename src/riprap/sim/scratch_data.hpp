// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a Scratch holds: for the sources of this folder only.

#include <optional>

#include "riprap/contact/pipeline.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/point_loads.hpp"

namespace riprap::sim {

struct ScratchData {
    contact::ContactPipeline pipeline;
    contact::BodyLoads loads;
    body::BodyKinematics kinematics;
    PointLoadSum point_loads;
    StageTimes times;
    std::optional<double> largest_time_step;  ///< of the solids [s]; set when it is first asked for
};

}  // namespace riprap::sim
