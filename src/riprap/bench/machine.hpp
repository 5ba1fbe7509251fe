// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/bench/result.hpp"

namespace riprap::bench {

/// Best of several passes each, about a second per number of threads: these are limits, not averages.
MachineLimits measure_machine(const std::vector<int>& thread_counts);

}  // namespace riprap::bench
