// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/run/strength/factor_search.hpp"

namespace riprap::run {
namespace {

/// Searches for a factor at which everything fails; counts the trials.
FactorSearch searched(double factor, const FactorSearch::Range& range, int& trials) {
    FactorSearch search(range);
    trials = 0;
    for (std::vector<double> next = search.next(); !next.empty(); next = search.next()) {
        EXPECT_LE(static_cast<int>(next.size()), std::max(2, range.at_a_time));
        for (const double tried : next) {
            search.tell(tried, tried < factor);
            ++trials;
        }
        EXPECT_LT(trials, 100);
    }
    return search;
}

TEST(FactorSearch, BracketsTheFactorWithinItsToleranceAtAnyNumberOfTrialsAtATime) {
    for (const int at_a_time : {1, 2, 3, 8}) {
        for (const double factor : {0.61, 0.97, 1.003, 1.284, 2.5, 4.93}) {
            int trials = 0;
            const FactorSearch found = searched(factor, {0.5, 5, 0.01, at_a_time}, trials);
            EXPECT_LT(found.stood(), factor);
            EXPECT_GE(found.failed(), factor);
            EXPECT_LE(found.failed() - found.stood(), 0.0101 * found.stood()) << factor << ' ' << at_a_time;
        }
    }
}

TEST(FactorSearch, KnowsBeforeHowManyTrialsItTakesAtMost) {
    for (const int at_a_time : {1, 2, 4}) {
        const int expected = FactorSearch({0.5, 5, 0.01, at_a_time}).trials_left();
        int trials = 0;
        searched(1.284, {0.5, 5, 0.01, at_a_time}, trials);
        EXPECT_LE(trials, expected);
        EXPECT_GE(2 * trials, expected);
    }
}

TEST(FactorSearch, SaysThatAllStandOrAllFail) {
    int trials = 0;
    const FactorSearch above = searched(7, {0.5, 5, 0.01, 2}, trials);
    EXPECT_EQ(above.stood(), 5);
    EXPECT_EQ(above.failed(), 0);
    EXPECT_EQ(trials, 2);
    const FactorSearch below = searched(0.4, {0.5, 5, 0.01, 1}, trials);
    EXPECT_EQ(below.stood(), 0);
    EXPECT_EQ(below.failed(), 0.5);
    EXPECT_EQ(trials, 3);
}

TEST(FactorSearch, BeginsAtFullStrengthAndTakesTheLowerEndOnlyWhereThatFails) {
    FactorSearch search({0.5, 5, 0.01, 2});
    EXPECT_THAT(search.next(), testing::ElementsAre(1, 5));
    search.tell(1, false);
    search.tell(5, false);
    EXPECT_EQ(search.next().front(), 0.5);
    EXPECT_THAT(FactorSearch({1.5, 3, 0.01, 1}).next(), testing::ElementsAre(1.5, 3));
}

TEST(FactorSearch, GoesOnBelowATrialThatFailedAndNamesThoseThatStoodAbove) {
    FactorSearch search({0.5, 5, 0.01, 2});
    for (const auto& [factor, stands] : {std::pair{1.0, true}, {2.0, false}, {3.0, true}, {5.0, false}}) {
        search.tell(factor, stands);
    }
    EXPECT_THAT(search.contradictions(), testing::ElementsAre(3));
    EXPECT_EQ(search.stood(), 1);
    EXPECT_EQ(search.failed(), 2);
}

}  // namespace
}  // namespace riprap::run
