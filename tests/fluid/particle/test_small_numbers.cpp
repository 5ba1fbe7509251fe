// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "riprap/fluid/particle/sweep/small_numbers.hpp"

namespace riprap::fluid {
namespace {

std::vector<std::int32_t> contents(const SmallNumbers& numbers) {
    std::vector<std::int32_t> out(numbers.size());
    numbers.copy(0, numbers.size(), out.data());
    return out;
}

TEST(small_numbers, come_back_whether_they_fit_two_bytes_or_not) {
    SmallNumbers numbers;
    for (const std::vector<std::int32_t>& given :
         {std::vector<std::int32_t>{0, 7, 65535}, {0, 65536, 2000000000}, {}, {3}, {70000}, {65535, 1, 2, 3, 4}}) {
        numbers.assign(given);
        EXPECT_EQ(contents(numbers), given);
        for (std::size_t i = 0; i < given.size(); ++i) {
            EXPECT_EQ(numbers[i], given[i]);
        }
    }
    std::int32_t part[2];
    numbers.copy(2, 2, part);
    EXPECT_EQ(part[0], 2);
    EXPECT_EQ(part[1], 3);
}

TEST(small_numbers, take_two_bytes_each_and_give_back_room_that_they_no_longer_need) {
    SmallNumbers numbers;
    numbers.assign(std::vector<std::int32_t>(1000, 65536));
    EXPECT_EQ(numbers.bytes(), 4000U);
    numbers.assign(std::vector<std::int32_t>(1000, 65535));
    EXPECT_EQ(numbers.bytes(), 2000U);
    numbers.assign(std::vector<std::int32_t>(10, 1));
    EXPECT_EQ(numbers.bytes(), 20U);
}

}  // namespace
}  // namespace riprap::fluid
