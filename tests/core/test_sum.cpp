// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "riprap/core/blocks.hpp"
#include "riprap/core/sum.hpp"

namespace riprap {
namespace {

using parallel::Block, parallel::Blocks, parallel::BlockTable, parallel::reduce_block, parallel::Total;

struct Work {
    double done{0}, fastest{0};
    Vec3 push{};
    std::int64_t count{0};

    template <class By>
    static void join(Work& a, const Work& b, const By& by) {
        by.add(a.done, b.done);
        by.largest(a.fastest, b.fastest);
        by.add(a.push, b.push);
        by.add(a.count, b.count);
    }
    friend bool operator==(const Work&, const Work&) = default;
};
struct Step {
    Work work;
    double heat{0};

    template <class By>
    static void join(Step& a, const Step& b, const By& by) {
        by.add(a.work, b.work);
        by.add(a.heat, b.heat);
    }
    friend bool operator==(const Step&, const Step&) = default;
};

/// Terms whose rounded sum depends on every change of order.
double term(std::int64_t i) {
    const auto x = static_cast<double>(i);
    return std::sin(x) * std::exp2(static_cast<double>(i % 40));
}
Step step_of(std::int64_t i) {
    const double a = term(i);
    return {{a, std::abs(a), {a, 2 * a + 1, term(3 * i)}, 1}, 0.1 * a};
}

class Sums : public ::testing::TestWithParam<int> {
 protected:
    void SetUp() override { parallel::set_thread_count(GetParam()); }
    void TearDown() override { parallel::set_thread_count(1); }
};

/// The definition: chains of 64 in a block of 2048, chains in order, blocks exactly.
TEST_P(Sums, IsTheExactSumOfBlocksOfChains) {
    for (const std::int64_t n : {0, 1, 63, 64, 65, 2048, 2049, 4096, 4097, 100'003}) {
        ExactSum expected;
        for (std::int64_t block = 0; block < n; block += 2048) {
            double total = 0;
            for (std::int64_t first = block; first < std::min(n, block + 2048); first += 64) {
                double chain = 0;
                for (std::int64_t i = first; i < std::min(n, first + 64); ++i) {
                    chain += term(i);
                }
                total += chain;
            }
            expected.add(total);
        }
        EXPECT_EQ(parallel::sum(n, term), expected.value()) << n;
    }
}

TEST_P(Sums, OfAStructAreThoseOfItsNumbersEachAlone) {
    const std::int64_t n = 100'003;
    const Step all = parallel::sum(n, step_of);
    EXPECT_EQ(all.work.done, parallel::sum(n, term));
    EXPECT_EQ(all.work.push.x, all.work.done);
    EXPECT_EQ(all.work.push.z, parallel::sum(n, [](std::int64_t i) { return term(3 * i); }));
    EXPECT_EQ(all.heat, parallel::sum(n, [](std::int64_t i) { return 0.1 * term(i); }));
    EXPECT_EQ(all.work.count, n);
    double fastest = 0;
    for (std::int64_t i = 0; i < n; ++i) {
        fastest = std::max(fastest, std::abs(term(i)));
    }
    EXPECT_EQ(all.work.fastest, fastest);
    const Vec3 push = parallel::sum(n, [](std::int64_t i) { return step_of(i).work.push; });
    EXPECT_EQ(push, all.work.push);
}

TEST_P(Sums, OfNothingIsNothing) { EXPECT_EQ(parallel::sum(0, step_of), Step{}); }

/// Deals whole blocks to holders at random, each with ghosts, and adds up what they own.
TEST_P(Sums, OfHoldersOfAnyBlocksWithGhostsAreThoseOfTheWhole) {
    const std::int64_t n = 41 * reduce_block + 700, whole = 42;
    const Step expected = parallel::sum(n, step_of);
    const BlockTable everything;
    ASSERT_EQ(parallel::sum(Blocks(everything, n), step_of), expected);
    std::mt19937_64 random(2);
    for (const std::size_t holders : {1U, 3U, 7U}) {
        std::vector<std::size_t> owner(static_cast<std::size_t>(whole));
        for (std::size_t& of : owner) {
            of = random() % holders;
        }
        Total<Step> total;
        double fastest = 0;
        for (std::size_t holder = holders; holder-- > 0;) {  // the last first
            BlockTable table;
            table.whole = whole;
            std::vector<std::int64_t> entity;
            for (std::int64_t number = 0; number < whole; ++number) {
                const bool own = owner[static_cast<std::size_t>(number)] == holder;
                if (own || random() % 3 == 0) {
                    const std::int64_t first = number * reduce_block, end = std::min(n, first + reduce_block);
                    table.add(number, own, end - first);
                    for (std::int64_t i = first; i < end; ++i) {
                        entity.push_back(i);
                    }
                }
            }
            const Blocks blocks(table, static_cast<std::int64_t>(entity.size()));
            const auto local = [&](std::int64_t i) { return step_of(entity[static_cast<std::size_t>(i)]); };
            total.add(parallel::part_of_sum(blocks, local));
            fastest = std::max(fastest, parallel::reduce(
                                            blocks, 0.0, [&](std::int64_t i) { return local(i).work.fastest; },
                                            [](double a, double b) { return std::max(a, b); }));
        }
        EXPECT_EQ(total.value(), expected) << holders << " holders";
        EXPECT_EQ(fastest, expected.work.fastest);
    }
}

TEST_P(Sums, VisitGhostsButDoNotCountThem) {
    BlockTable table;
    table.whole = 9;
    table.add(2, true, reduce_block);
    table.add(4, false, reduce_block);
    table.add(8, true, 5);
    const Blocks blocks(table, 2 * reduce_block + 5);
    EXPECT_EQ(blocks.whole(), 9);
    EXPECT_EQ(blocks[2], (Block{8, true, 2 * reduce_block, 5}));
    std::vector<int> visits(static_cast<std::size_t>(blocks.size()));
    const auto count = [&](std::int64_t i) -> std::int64_t {
        ++visits[static_cast<std::size_t>(i)];
        return 1;
    };
    EXPECT_EQ(parallel::sum(blocks, count), reduce_block + 5);
    EXPECT_EQ(std::ranges::count(visits, 1), blocks.size());
}

INSTANTIATE_TEST_SUITE_P(OneToFour, Sums, ::testing::Values(1, 2, 3, 4));

}  // namespace
}  // namespace riprap
