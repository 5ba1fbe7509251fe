// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <array>
#include <numeric>
#include <vector>

#include "riprap/fluid/particle/sweep/lanes.hpp"

namespace riprap::fluid {
namespace {

// Whole numbers, whose sums are exact in any order; every lane has another.
Lanes number(float first) {
    std::array<float, lane_count> a;
    std::iota(a.begin(), a.end(), first);
    return Lanes::load(a.data());
}
/// Sums over the parts of a lane, as the sweep does before it sums over targets.
LanePart over_parts(Lanes a) {
    LanePart sum(0);
    for (std::size_t k = 0; k < Lanes::part_count; ++k) {
        sum += part_of(a, k);
    }
    return sum;
}
float of_candidate(Lanes a, int candidate) {
    return a[candidate] + a[4 + candidate] + a[8 + candidate] + a[12 + candidate];
}

TEST(lanes, hold_target_l_over_4_and_candidate_l_mod_4) {
    const std::array<float, 4> four{5, 7, 11, 13};
    const std::array<std::int32_t, 4> whole{-3, 2, 40, 9};
    const Lanes targets = targets_in_lanes(four.data()), candidates = candidates_in_lanes(four.data());
    const Lanes apart = difference(targets_in_lanes(whole.data()), candidates_in_lanes(whole.data()));
    for (int l = 0; l < lane_count; ++l) {
        const auto target = static_cast<std::size_t>(l / 4), candidate = static_cast<std::size_t>(l % 4);
        EXPECT_EQ(targets[l], four[target]);
        EXPECT_EQ(candidates[l], four[candidate]);
        EXPECT_EQ(apart[l], static_cast<float>(whole[target] - whole[candidate]));
    }
}

TEST(lanes, sums_over_candidates_are_those_of_each_target) {
    const Lanes a = number(3);
    const auto sums = sum_of_candidates(a);
    for (int t = 0; t < 4; ++t) {
        EXPECT_EQ(sums[t], a[4 * t] + a[4 * t + 1] + a[4 * t + 2] + a[4 * t + 3]);
    }
}

TEST(lanes, sums_over_targets_are_those_of_each_candidate_of_one_two_and_four_numbers) {
    const std::array<Lanes, 4> numbers{number(1), number(100), number(-20), number(1000)};
    const LanePart a = over_parts(numbers[0]), b = over_parts(numbers[1]), c = over_parts(numbers[2]),
                   d = over_parts(numbers[3]);
    const auto one = sums_of_targets(a);
    const auto two = sums_of_targets(a, b);
    const Lanes four = sums_of_targets(a, b, c, d);
    for (int k = 0; k < 4; ++k) {
        for (int candidate = 0; candidate < 4; ++candidate) {
            const float expected = of_candidate(numbers[static_cast<std::size_t>(k)], candidate);
            EXPECT_EQ(four[4 * k + candidate], expected);
            if (k < 2) {
                EXPECT_EQ(two[4 * k + candidate], expected);
            }
            if (k < 1) {
                EXPECT_EQ(one[candidate], expected);
            }
        }
    }
}

TEST(lanes, the_numbers_of_set_bits_are_written_in_order) {
    for (const std::int32_t first : {0, 4096, -4}) {
        for (const std::uint32_t bits : {0U, 0xFFFFU, 0x8001U, 0x5A3CU}) {
            std::vector<std::int32_t> out(32), expected;
            for (int l = 0; l < lane_count; ++l) {
                if ((bits >> l & 1U) != 0) {
                    expected.push_back(first + l);
                }
            }
            out.resize(static_cast<std::size_t>(write_selected(bits, first, out.data())));
            EXPECT_EQ(out, expected);
        }
    }
}

}  // namespace
}  // namespace riprap::fluid
