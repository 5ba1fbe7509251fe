// SPDX-License-Identifier: Apache-2.0
// Angle by which blocks tip early as their feet are elastic, as `riprap check` predicts it.
#include "riprap/run/remedy/tipping_bias.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/contact/elastic_foot.hpp"
#include "riprap/run/check/check_case.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

using testing::HasSubstr;

/// `count` bricks 0.2 x 0.4 x 0.3 m (x, y, z) on each other on a floor.
scene::LoadedCase bricks(int count, double stiffness, const std::string& sides = "contactor") {
    return scene::read_case_text(
        fmt::format("gravity = [0.0, 0.0, -9.81]\nend = 1.0\n[material.rock]\ndensity = 2500.0\n"
                    "normal_stiffness = {}\nfriction_coefficient = 0.5\n[solid]\nsides = '{}'\n[[body]]\nname = "
                    "\"floor\"\nmaterial = \"rock\"\n"
                    "shape = {{ half_space = {{ normal = [0.0, 0.0, 1.0], offset = 0.0 }} }}\nfixed = true\n"
                    "[[body]]\nname = \"brick\"\nmaterial = \"rock\"\nshape = {{ box = [0.2, 0.4, 0.3] }}\n"
                    "position = [0.0, 0.0, 0.15]\nrepeat = {{ counts = [1, 1, {}], pitch = [1.0, 1.0, 0.3] }}\n",
                    stiffness, sides, count),
        "case.toml", "/nonexistent", {});
}

TEST(TippingBias, of_one_brick_is_that_of_its_foot) {
    const scene::LoadedCase loaded = bricks(1, 1e8);
    const auto bias = largest_tipping_bias(loaded.model, loaded.state);
    ASSERT_TRUE(bias);
    const contact::ElasticFoot foot{0.2, 0.4, 0.15, 2500 * 0.2 * 0.4 * 0.3 * 9.81, 1e8 / 0.1};
    EXPECT_NEAR(bias->rigid, std::atan(0.1 / 0.15), 1e-9);
    EXPECT_NEAR(bias->elastic, contact::tipping_slope(foot), 1e-9);
    EXPECT_EQ(bias->above, 0);
}

TEST(TippingBias, the_lowest_brick_of_a_column_tips_earliest_with_all_that_it_carries) {
    const scene::LoadedCase loaded = bricks(5, 1e8);
    const auto bias = largest_tipping_bias(loaded.model, loaded.state);
    ASSERT_TRUE(bias);
    EXPECT_EQ(bias->above, 4);
    EXPECT_EQ(bias->body.value, 1);
    EXPECT_NEAR(bias->rigid, std::atan(0.1 / 0.75), 1e-9);
}

TEST(TippingBias,
     falls_with_the_cube_root_of_the_stiffness_and_the_stiffness_reported_brings_it_to_a_tenth_of_a_degree) {
    const auto soft = bricks(5, 1e9), stiff = bricks(5, 1e12);
    const double a = largest_tipping_bias(soft.model, soft.state)->bias();
    const double b = largest_tipping_bias(stiff.model, stiff.state)->bias();
    EXPECT_NEAR(a / b, 10, 0.5);
    const auto wanted = bricks(5, 1e9 * largest_tipping_bias(soft.model, soft.state)->factor);
    EXPECT_NEAR(largest_tipping_bias(wanted.model, wanted.state)->bias(), tolerated_tipping_bias,
                0.1 * tolerated_tipping_bias);
}

TEST(TippingBias, is_reported_by_check_with_a_sufficient_stiffness) {
    const CaseCheck check = check_case(bricks(5, 1e9));
    EXPECT_THAT(check_text(check), HasSubstr("  tipping       'brick[0]' and the 4 above it tip at "));
    EXPECT_THAT(check_text(check), HasSubstr("for 0.1 deg set normal_stiffness = "));
    EXPECT_THAT(check_json(check), HasSubstr("\"stiffness_for_0.1_deg\""));
}

TEST(TippingBias, is_none_where_feet_stand_on_their_corners) {
    EXPECT_FALSE(check_case(bricks(5, 1e9, "both")).tipping);
}

}  // namespace
}  // namespace riprap::run
