// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/sweep.hpp"

namespace riprap::fluid {

struct SweepScratchData {};

}  // namespace riprap::fluid
