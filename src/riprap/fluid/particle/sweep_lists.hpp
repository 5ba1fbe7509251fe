// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/sweep.hpp"

namespace riprap::fluid {

/// Lists of neighbours and buffers of the sums over them, between fluid and walls: a cache, kept from step to step.
struct SweepLists {
    SweepScratch fluid_fluid;
    SweepScratch fluid_walls{SweepScratch::sharing_buffers(fluid_fluid)};
    SweepScratch walls_fluid{SweepScratch::sharing_buffers(fluid_fluid)};

    std::size_t bytes() const { return fluid_fluid.bytes() + fluid_walls.bytes() + walls_fluid.bytes(); }
};

}  // namespace riprap::fluid
