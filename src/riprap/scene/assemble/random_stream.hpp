// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "riprap/core/quat.hpp"

namespace riprap::scene {

/// Random numbers that depend on (seed, name, number) alone, not on what was drawn before or for others: adding a
/// block to a case leaves the others where they were. SplitMix64 [Steele2014].
class RandomStream {
 public:
    RandomStream(std::uint64_t seed, std::string_view name, std::uint64_t number);

    double uniform();  ///< in [0, 1)
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    Quat orientation(bool is_planar);  ///< uniform over all turns, or over turns about z

 private:
    std::uint64_t key_, count_{0};
};

/// The seed of one part of a case: its own where given, else made from that of the case and its name.
std::uint64_t seed_of(std::uint64_t case_seed, std::string_view name);

}  // namespace riprap::scene
