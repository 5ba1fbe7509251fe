// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "riprap/scene/read_case.hpp"

namespace riprap::run {

/// Cost of a run on this machine, by its first steps: later ones cost more where water breaks or a pile falls apart.
struct RunCost {
    std::int64_t particles{0}, free_bodies{0};
    std::int64_t steps{0};       ///< to the end, at the length of those that were taken
    double seconds_per_step{0};  ///< median [s]
    std::string refusal;         ///< what the first steps were refused for; empty where they were not
    double seconds() const { return static_cast<double>(steps) * seconds_per_step; }
};

/// Takes steps of a case for about `budget` seconds, three at least, without an output. The first one, which builds
/// lists, does not count.
RunCost measure_cost(scene::LoadedCase loaded, double budget);

}  // namespace riprap::run
