// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sixteen pairs of samples side by side: lane l stands for sample l/4 of one four and l%4 of the other. In float, as
// the water's own sweeps, or in double for plain sums, which are written for brevity.

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "riprap/fluid/particle/sweep/lanes.hpp"

namespace riprap::coupling {

inline constexpr std::size_t four_size = 4;

template <class Real>
using Sixteen = Wide<Real, fluid::lane_count>;
/// A number of each of four samples.
template <class Real>
using Four = std::array<Real, four_size>;
/// The same of vectors: [axis][sample].
template <class Real>
using Four3 = std::array<Four<Real>, 3>;

/// Lane l gets of(l).
template <class Real, class Of>
inline Sixteen<Real> lanes_of(const Of& of) {
    std::array<Real, fluid::lane_count> lanes;
    for (std::size_t l = 0; l < lanes.size(); ++l) {
        lanes[l] = of(l);
    }
    return Sixteen<Real>::load(lanes.data());
}
/// Lane l gets entry l%4,
template <class Real>
inline Sixteen<Real> others_in_lanes(const Four<Real>& four) {
    if constexpr (std::is_same_v<Real, float>) {
        return fluid::candidates_in_lanes(four.data());
    } else {
        return lanes_of<Real>([&](std::size_t l) { return four[l % four_size]; });
    }
}
/// or entry l/4.
template <class Real>
inline Sixteen<Real> own_in_lanes(const Four<Real>& four) {
    if constexpr (std::is_same_v<Real, float>) {
        return fluid::targets_in_lanes(four.data());
    } else {
        return lanes_of<Real>([&](std::size_t l) { return four[l / four_size]; });
    }
}
/// Differences of places in whole numbers, modulo 2^32.
template <class Real>
inline Sixteen<Real> difference_in_lanes(const fluid::IntLanes& own, const fluid::IntLanes& other) {
    if constexpr (std::is_same_v<Real, float>) {
        return fluid::difference(own, other);
    } else {
        return lanes_of<Real>([&](std::size_t lane) {
            const auto l = static_cast<std::int64_t>(lane);
            const auto d = static_cast<std::uint32_t>(own[l]) - static_cast<std::uint32_t>(other[l]);
            return static_cast<Real>(static_cast<std::int32_t>(d));
        });
    }
}

inline Sixteen<float> root(Sixteen<float> a) { return distance(max(a, Sixteen<float>(1e-30))); }
inline Sixteen<double> root(Sixteen<double> a) { return sqrt(a); }
/// 1/sqrt(a) for a > 0
inline Sixteen<float> inverse_root(Sixteen<float> a) { return reciprocal_sqrt(a); }
inline Sixteen<double> inverse_root(Sixteen<double> a) { return Sixteen<double>(1) / sqrt(a); }
inline Sixteen<float> inverse(Sixteen<float> a) { return reciprocal(a); }
inline Sixteen<double> inverse(Sixteen<double> a) { return Sixteen<double>(1) / a; }

/// One bit for each lane in which the number is not zero but negative.
template <class Real>
inline std::uint32_t negative_bits(Sixteen<Real> a) {
    return bits_below(a, Sixteen<Real>(0));
}
template <class Real>
inline std::uint32_t bits_of(WideMask<Real, fluid::lane_count> mask) {
    return negative_bits(select(mask, Sixteen<Real>(-1), Sixteen<Real>(0)));
}

/// Adds to each of one four the sum over those of the other, in a fixed order.
template <class Real>
inline void add_to_own(Four<Real>& four, Sixteen<Real> lanes) {
    if constexpr (std::is_same_v<Real, float>) {
        fluid::add_to(four.data(), fluid::sum_of_candidates(lanes));
    } else {
        for (std::size_t l = 0; l < fluid::lane_count; ++l) {
            four[l / four_size] += lanes[static_cast<std::int64_t>(l)];
        }
    }
}
template <class Real, std::size_t Count>
inline void add_to_own(std::array<Four<Real>, Count>& fours, const std::array<Sixteen<Real>, Count>& lanes) {
    for (std::size_t k = 0; k < Count; ++k) {
        add_to_own<Real>(fours[k], lanes[k]);
    }
}
inline fluid::LanePart sum_of_parts(Sixteen<float> lanes) {
    fluid::LanePart sum = fluid::part_of(lanes, 0);
    for (std::size_t k = 1; k < Sixteen<float>::part_count; ++k) {
        sum += fluid::part_of(lanes, k);
    }
    return sum;
}
/// The same the other way, two or four numbers at once.
template <class Real, std::size_t Count>
inline void add_to_others(std::array<Four<Real>, Count>& fours, const std::array<Sixteen<Real>, Count>& lanes) {
    static_assert(Count == 2 || Count == 4);
    if constexpr (!std::is_same_v<Real, float>) {
        for (std::size_t k = 0; k < Count; ++k) {
            for (std::size_t l = 0; l < fluid::lane_count; ++l) {
                fours[k][l % four_size] += lanes[k][static_cast<std::int64_t>(l)];
            }
        }
    } else if constexpr (Count == 2) {
        fluid::add_to(fours[0].data(), fluid::sums_of_targets(sum_of_parts(lanes[0]), sum_of_parts(lanes[1])));
    } else {
        fluid::add_to(fours[0].data(), fluid::sums_of_targets(sum_of_parts(lanes[0]), sum_of_parts(lanes[1]),
                                                              sum_of_parts(lanes[2]), sum_of_parts(lanes[3])));
    }
}

}  // namespace riprap::coupling
