// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/sim/state.hpp"

namespace riprap::run {

/// The hash of a State that is told to the world, so that others can compute it: XXH3, 64 bits without a seed, over
/// every field in the order of State::visit_fields - its name, where it is an array its length as a 64-bit integer, and
/// its values as in memory (little-endian). Equal at any thread count and after a restart.
std::uint64_t xxh3_of(const sim::State& state);

}  // namespace riprap::run
