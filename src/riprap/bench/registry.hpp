// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/bench/result.hpp"

namespace riprap::bench {

/// Every bench, in the order in which they run. One explicit list: nothing registers itself.
std::span<const Bench> all_benches();

}  // namespace riprap::bench
