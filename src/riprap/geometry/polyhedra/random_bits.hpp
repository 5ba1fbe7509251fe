// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace riprap::geometry {

/// Mixes two words into one that looks random (SplitMix64) [Steele2014]. Counter-based: the value at a place does not
/// depend on what was drawn before, so block generators are deterministic in any order of work.
constexpr std::uint64_t mix_bits(std::uint64_t key, std::uint64_t counter) {
    std::uint64_t z = key + 0x9e3779b97f4a7c15ULL * (counter + 1);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
}

/// A number in [0, 1) from the upper 53 bits; the same on every machine.
constexpr double unit_interval(std::uint64_t bits) { return static_cast<double>(bits >> 11U) * 0x1.0p-53; }

}  // namespace riprap::geometry
