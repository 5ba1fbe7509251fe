// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fluid/sph/water.hpp"

namespace riprap::fluid::testing {
namespace {

TEST(StillWater, stays_still_and_weighs_on_the_floor_what_it_weighs) {  // E1, coarse
    const double depth = 0.5, g = 9.81;
    Water water;
    water.settings = settings_2d(depth / 12, 10 * std::sqrt(g * depth));
    water.gravity = {0, -g, 0};
    add_tank(water, 0.5, 0.7, true);
    add_still_water(water, 0.5, depth);
    const double weight = 1000 * g * depth * 0.5;
    double floor_impulse = 0;
    while (water.time < 2 && water.report.problem.empty()) {
        water.step();
        if (water.time > 1) {
            for (const Vec3& f : water.walls.pressure_force) {
                floor_impulse -= f.y * water.last_dt;
            }
        }
    }
    ASSERT_EQ(water.report.problem, "");
    EXPECT_NEAR(floor_impulse, weight * 1, 0.01 * weight);
    EXPECT_LT(water.report.max_speed, 0.01 * std::sqrt(g * depth));
    double squares = 0;
    for (std::size_t i = 0; i < water.state.position.size(); ++i) {
        const double error =
            pressure_of(water.settings, water.state.density[i]) - 1000 * g * (depth - water.state.position[i].y);
        squares += error * error;
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(water.state.size())), 0.02 * 1000 * g * depth);
}

}  // namespace
}  // namespace riprap::fluid::testing
