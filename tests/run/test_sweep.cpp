// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/core/error.hpp"
#include "riprap/run/sweep.hpp"

namespace riprap {
namespace {

using ::testing::ElementsAre;

TEST(SweepWords, CommasWithinBracketsAndQuotesDoNotPartValues) {
    const run::Variation variation = run::read_variation("gravity = [0,0,-9.81], [0, 0, -1.62],\"a,b\"");
    EXPECT_EQ(variation.key, "gravity");
    EXPECT_THAT(variation.values, ElementsAre("[0,0,-9.81]", "[0, 0, -1.62]", "\"a,b\""));
    EXPECT_THROW(run::read_variation("end"), CaseError);
    EXPECT_THROW(run::read_variation("end=1,,2"), CaseError);
}

TEST(SweepWords, AGridHasEveryCombinationAndAListItsLines) {
    const auto grid = run::grid_of({{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}});
    ASSERT_EQ(grid.size(), 6U);
    EXPECT_EQ(grid[5].name, "run_006");
    EXPECT_THAT(grid[4].overrides, ElementsAre("a=2", "b=y"));
    const auto list = run::list_of("a, b\n# nothing\n1, [2,3]\n4, 5\n", "runs.txt");
    ASSERT_EQ(list.size(), 2U);
    EXPECT_THAT(list[0].overrides, ElementsAre("a=1", "b=[2,3]"));
    EXPECT_THROW(run::list_of("a,b\n1\n", "runs.txt"), CaseError);
}

}  // namespace
}  // namespace riprap
