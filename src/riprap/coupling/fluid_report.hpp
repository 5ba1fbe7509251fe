// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/coupling/wall_passages.hpp"
#include "riprap/fluid/open/open_boundary.hpp"
#include "riprap/fluid/particle/particle_scheme.hpp"

namespace riprap::coupling {

/// Report of a fluid on one span of a step.
struct FluidStep {
    fluid::FluidReport fluid;
    std::vector<double> own;      ///< amounts of the accounts that the fluid names itself, in their order [J]
    std::vector<double> earlier;  ///< amounts of the same accounts that were due before the kick; none = zero [J]
    fluid::Passage passage;       ///< through inflows and outflows, after the kick
    WallPassages through_walls;
    std::string intruder;  ///< a moving body among the layers of an opening, and which; empty = none
};

}  // namespace riprap::coupling
