// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/past_caches.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

#include "riprap/linear/huge_pages.hpp"

namespace riprap::linear {
namespace {

TEST(PastCaches, stores_copy_whole_lines_and_no_more) {
    StreamVector<double> from(24), to(40, -1);
    std::iota(from.begin(), from.end(), 1.0);
    store_past_caches(from.data(), from.size(), to.data() + 8);
    finish_stores();
    for (std::size_t i = 0; i < to.size(); ++i) {
        EXPECT_EQ(to[i], i < 8 || i >= 32 ? -1 : from[i - 8]) << i;
    }
}

TEST(StreamVector, begins_with_a_line_of_the_cache) {
    for (const std::size_t size : {std::size_t{1}, std::size_t{1000}, std::size_t{1} << 20}) {
        StreamVector<double> numbers;
        make_room(size, numbers);
        EXPECT_GE(numbers.capacity(), size);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(numbers.data()) % 64, 0U);
    }
}

}  // namespace
}  // namespace riprap::linear
