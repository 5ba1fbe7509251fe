// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>

#include "riprap/core/parallel.hpp"
#include "riprap/core/selection.hpp"

namespace riprap {
namespace {

class ThreadCounts : public ::testing::TestWithParam<int> {
 protected:
    void SetUp() override { parallel::set_thread_count(GetParam()); }
    void TearDown() override { parallel::set_thread_count(1); }
};

TEST_P(ThreadCounts, ASumHasTheSameBitsAsOnOneThread) {
    const std::int64_t n = 100'003;
    const auto term = [](std::int64_t i) {
        return std::sin(static_cast<double>(i)) * std::exp2(static_cast<double>(i % 40));
    };
    const auto plus = [](double a, double b) { return a + b; };
    const double many = parallel::reduce(n, 0.0, term, plus);
    parallel::set_thread_count(1);
    EXPECT_EQ(many, parallel::reduce(n, 0.0, term, plus));
}

static_assert(!parallel::has_own_bytes<bool>, "two threads would write bits of one byte of a std::vector<bool>");
static_assert(parallel::has_own_bytes<std::uint8_t>);

TEST_P(ThreadCounts, AnyOfSeesASingleEntryWhereverItLies) {
    const std::int64_t n = 64 * parallel::reduce_block;
    for (int k = 0; k < 64; ++k) {
        const std::int64_t one = k * parallel::reduce_block + 17 * k;
        ASSERT_TRUE(parallel::any_of(n, [one](std::int64_t i) { return i == one; })) << one;
    }
    EXPECT_FALSE(parallel::any_of(n, [](std::int64_t) { return false; }));
    EXPECT_FALSE(parallel::any_of(0, [](std::int64_t) { return true; }));
}

TEST_P(ThreadCounts, AScanIsTheRunningSum) {
    std::vector<std::int32_t> in(70'001), out(in.size());
    for (std::size_t i = 0; i < in.size(); ++i) {
        in[i] = static_cast<std::int32_t>(i % 1000) - 5;
    }
    const std::int32_t total = parallel::exclusive_scan<std::int32_t>(in, out);
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < in.size(); ++i) {
        ASSERT_EQ(out[i], sum);
        sum += in[i];
    }
    EXPECT_EQ(total, sum);
}

TEST_P(ThreadCounts, ASortByKeyIsStableAndComplete) {
    std::mt19937_64 random(7);
    std::vector<std::uint64_t> keys(100'000), key_scratch;
    std::vector<std::uint32_t> values(keys.size()), value_scratch;
    for (auto& key : keys) {
        key = random() % 1000 | (random() % 3) << 50;
    }
    std::iota(values.begin(), values.end(), 0U);
    const auto original = keys;
    parallel::sort_by_key(keys, values, key_scratch, value_scratch);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        ASSERT_EQ(keys[i], original[values[i]]);
        if (i > 0) {
            ASSERT_TRUE(keys[i - 1] < keys[i] || (keys[i - 1] == keys[i] && values[i - 1] < values[i]));
        }
    }
}

TEST_P(ThreadCounts, UnevenLoopsVisitEveryEntryOnce) {
    std::vector<int> visits(12'345);
    parallel::for_each_uneven(static_cast<std::int64_t>(visits.size()), 37,
                              [&](std::int64_t i) { ++visits[static_cast<std::size_t>(i)]; });
    for (const int count : visits) {
        ASSERT_EQ(count, 1);
    }
}

TEST_P(ThreadCounts, FewerEntriesThanThreadsAreVisitedOnceToo) {
    std::vector<int> visits(3);
    parallel::for_each_uneven(3, 1, [&](std::int64_t i) { ++visits[static_cast<std::size_t>(i)]; });
    EXPECT_EQ(visits, (std::vector<int>{1, 1, 1}));
}

TEST_P(ThreadCounts, AnUnevenLoopWhoseCostIsAllAtItsEndVisitsEveryEntryOnce) {
    std::vector<double> sums(4'000);
    std::vector<int> visits(sums.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(sums.size()), 16, [&](std::int64_t i) {
        const auto entry = static_cast<std::size_t>(i);
        for (std::int64_t k = 0; k < (i < 3'000 ? 0 : 2'000); ++k) {
            sums[entry] += static_cast<double>(k);
        }
        ++visits[entry];
    });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 4'000);
    EXPECT_EQ(sums.back(), 1'999'000);
}

TEST_P(ThreadCounts, LoopsOverNothingDoNothing) {
    std::vector<std::uint64_t> keys, key_scratch;
    std::vector<std::uint32_t> values, value_scratch;
    parallel::sort_by_key(keys, values, key_scratch, value_scratch);
    parallel::for_each(0, [](std::int64_t) { FAIL(); });
    EXPECT_EQ(parallel::exclusive_scan<std::int32_t>({}, {}), 0);
    EXPECT_EQ(parallel::reduce(
                  0, 7.0, [](std::int64_t) { return 1.0; }, [](double a, double b) { return a + b; }),
              7.0);
}

TEST_P(ThreadCounts, AScanMayOverwriteItsInput) {
    std::vector<std::int64_t> values(40'000, 3);
    EXPECT_EQ(parallel::exclusive_scan<std::int64_t>(values, values), 120'000);
    for (std::size_t i = 0; i < values.size(); ++i) {
        ASSERT_EQ(values[i], 3 * static_cast<std::int64_t>(i));
    }
}

TEST_P(ThreadCounts, ASortTellsKeysApartByTheirHighestAndLowestBits) {
    const std::uint64_t high = std::uint64_t{1} << 63;
    std::vector<std::uint64_t> keys{high | 1, 1, high, 0, ~std::uint64_t{0}}, key_scratch;
    std::vector<std::uint32_t> values{0, 1, 2, 3, 4}, value_scratch;
    parallel::sort_by_key(keys, values, key_scratch, value_scratch);
    EXPECT_EQ(values, (std::vector<std::uint32_t>{3, 1, 2, 0, 4}));
}

TEST_P(ThreadCounts, ALoopThatThrowsReportsTheFirstFailureInOrderOfIndex) {
    const auto fail_at = [](std::int64_t i) {
        if (i == 4000 || i == 9000) {
            throw std::runtime_error(std::to_string(i));
        }
    };
    try {
        parallel::for_each_uneven(10'000, 50, fail_at);
        FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "4000");
    }
}

TEST_P(ThreadCounts, ALoopInsideALoopRunsOnItsCallersThread) {
    std::vector<double> sums(64);
    parallel::for_each_uneven(64, 1, [&](std::int64_t i) {
        sums[static_cast<std::size_t>(i)] = parallel::reduce(
            10'000, 0.0, [i](std::int64_t k) { return 1.0 / static_cast<double>(i + k + 1); },
            [](double a, double b) { return a + b; });
    });
    parallel::set_thread_count(1);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double alone = parallel::reduce(
            10'000, 0.0,
            [i](std::int64_t k) { return 1.0 / static_cast<double>(static_cast<std::int64_t>(i) + k + 1); },
            [](double a, double b) { return a + b; });
        ASSERT_EQ(sums[i], alone);
    }
}

TEST_P(ThreadCounts, ASelectionIsInTheOneOrderOfAllAndCounted) {
    for (const std::int64_t n : {0, 1, 2047, 2048, 2049, 50'000}) {
        for (const std::size_t every : {1, 3, 2048, 100'000}) {
            const auto is = [every](std::size_t i) { return (i + 1) % every == 0; };
            std::vector<std::size_t> expected;
            for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
                if (is(i)) {
                    expected.push_back(i);
                }
            }
            const std::int64_t before = parallel::entries_selected();
            ASSERT_EQ(parallel::select(n, is), expected) << n << " entries, one of " << every;
            ASSERT_EQ(parallel::entries_selected() - before, std::ssize(expected));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OneToFour, ThreadCounts, ::testing::Values(1, 2, 3, 4));

}  // namespace
}  // namespace riprap
