// SPDX-License-Identifier: Apache-2.0
#pragma once

// Buffers of the methods: for the sources of this folder that ask methods for them.

#include "riprap/sim/methods.hpp"
#include "riprap/sim/scratch_data.hpp"

namespace riprap::sim {

struct MethodScratch {
    Solids::Scratch solid;
    Fluids::Scratch fluid;
};

}  // namespace riprap::sim
