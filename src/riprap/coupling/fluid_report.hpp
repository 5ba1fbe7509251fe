// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/fluid/open/open_boundary.hpp"
#include "riprap/fluid/particle/particle_scheme.hpp"

namespace riprap::coupling {

/// What a fluid brings in one span of a step.
struct FluidStep {
    fluid::FluidReport fluid;
    double absorbed{0};      ///< by sponges [J]
    double flow_work{0};     ///< on the layers of inflows and outflows [J]
    fluid::Passage passage;  ///< through inflows and outflows, after the kick
    std::string intruder;    ///< a moving body among the layers of an opening, and which; empty = none
};

}  // namespace riprap::coupling
