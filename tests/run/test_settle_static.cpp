// SPDX-License-Identifier: Apache-2.0
// Bodies that settle without inertia, and what they start with at time 0.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/core/error.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/sim/time_step.hpp"

namespace riprap::run {
namespace {

constexpr double gravity = 9.81, degree = M_PI / 180;

/// A block on a plane that dips, x down the dip; friction by its angle.
std::string block_on_slope(const std::string& method, double slope, double friction_angle) {
    return "dimension = 2\ngravity = [" + std::to_string(gravity * std::sin(slope * degree)) + ", " +
           std::to_string(-gravity * std::cos(slope * degree)) + "]\nend = 0.5\n[solid]\nmethod = \"" + method +
           "\"\n[material.rock]\ndensity = 2500.0\nnormal_stiffness = 1.0e8\n" +
           "friction_coefficient = " + std::to_string(std::tan(friction_angle * degree)) + R"(
[[body]]
name = "ground"
shape = { box = [8.0, 1.0] }
position = [2.0, -0.5]
material = "rock"
fixed = true
[[body]]
name = "block"
shape = { box = [1.0, 0.2] }
position = [0.0, 0.1]
material = "rock"
)";
}

std::unique_ptr<Simulation> start(const std::string& text, const std::vector<std::string>& overrides) {
    return std::make_unique<Simulation>(scene::read_case_text(text, "case.toml", ".", overrides));
}

double way_of(Simulation& simulation) {
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        EXPECT_TRUE(outcome.is_accepted()) << outcome.why.with_remedy();
        if (!outcome.is_accepted()) {
            break;
        }
    }
    return sim::evaluate(*sim::find_column(simulation.model(), "block.displacement.x"), simulation.now());
}

class SettleStatic : public testing::TestWithParam<const char*> {};

TEST_P(SettleStatic, ABlockThatCannotStandStartsFromRestAndSlidesByCoulombAndNewton) {
    const auto settled = start(block_on_slope(GetParam(), 30, 29), {"settle=0.2", "settle_static=true"});
    EXPECT_EQ(settled->initial().bodies.velocity[1], Vec3{});
    const double a = gravity * (std::sin(30 * degree) - std::cos(30 * degree) * std::tan(29 * degree));
    EXPECT_NEAR(way_of(*settled), 0.5 * a * 0.25, 0.01 * 0.5 * a * 0.25);
}

TEST_P(SettleStatic, VelocitiesOfTheCaseBeginAtTime0) {
    const std::string text = block_on_slope(GetParam(), 0, 0) + "velocity = [2.0, 0.0]\n";
    for (const char* is_static : {"settle_static=true", "settle_static=false"}) {
        SCOPED_TRACE(is_static);
        const auto settled = start(text, {"settle=0.1", is_static});
        EXPECT_NEAR(settled->initial().bodies.position[1].x, 0, 1e-4);
        EXPECT_NEAR(way_of(*settled), 1.0, 1e-4);
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, SettleStatic,
                         testing::Values("distance_potential_dem", "planar_dda", "implicit_dda", "explicit_dda"),
                         [](const auto& test) { return std::string(test.param); });

TEST(SettleStatic, ExplicitMethodsTakeAShareOfTheVelocityInEachStep) {
    for (const auto& [method, share] : {std::pair{"distance_potential_dem", 0.1}, {"explicit_dda", 0.01}}) {
        SCOPED_TRACE(method);
        const std::string text = block_on_slope(method, 30, 29);
        const auto early = start(text, {"settle=0.2", "settle_static=true"});
        const auto late = start(text, {"settle=0.3", "settle_static=true"});
        const double a = gravity * (std::sin(30 * degree) - std::cos(30 * degree) * std::tan(29 * degree));
        sim::State state = late->initial();
        const double dt = sim::largest_time_step(late->model(), sim::time_step_bound(late->model(), state));
        const double creep = a * dt / share * 0.1;  // at its terminal velocity
        EXPECT_NEAR(late->initial().bodies.position[1].x - early->initial().bodies.position[1].x, creep, 0.05 * creep);
    }
}

TEST(SettleStatic, GravityDoesNotTurnBeforeTime0AndALoadThatStopsLaterActs) {
    const std::string text = block_on_slope("planar_dda", 0, 45);
    const auto level = start(text, {"settle=1.0", "settle_static=true"});
    const auto turning = start(text, {"settle=1.0", "settle_static=true",
                                      "gravity={value=[0.0, -9.81], rotation={axis=[0.0, 0.0, 1.0], rate=0.1}}"});
    EXPECT_EQ(turning->initial().bodies.position[1], level->initial().bodies.position[1]);
    const auto lifted =
        start(text + "load = [{ force = [0.0, 2000.0], stop = 1.0e-9 }]\n", {"settle=1.0", "settle_static=true"});
    const double sunk = 0.1 - level->initial().bodies.position[1].y, weight = 2500 * 0.2 * gravity;
    EXPECT_NEAR((0.1 - lifted->initial().bodies.position[1].y) / sunk, 1 - 2000 / weight, 0.01);
}

TEST(SettleTimeStep, AWideStepOfAMethodWithoutInertiaReachesTheSameRest) {
    const std::string text = block_on_slope("planar_dda", 20, 30);
    const auto wide = start(text, {"settle=1.0", "settle_static=true", "settle_time_step=0.05"});
    const auto narrow = start(text, {"settle=1.0", "settle_static=true"});
    const double sunk = 0.1 - narrow->initial().bodies.position[1].y;
    EXPECT_GT(sunk, 1e-7);
    EXPECT_NEAR(0.1 - wide->initial().bodies.position[1].y, sunk, 1e-3 * sunk);
    EXPECT_NEAR(wide->model().time.end, 0.5, 0);
}

TEST_P(SettleStatic, FrictionOfTheSettlingHoldsABlockUntilTime0) {
    const auto settled = start(block_on_slope(GetParam(), 30, 10),
                               {"settle=0.1", "settle_static=true", "settle_friction=2.0", "end=0.2"});
    EXPECT_NEAR(settled->initial().bodies.position[1].x, 0, 1e-4);
    const double a = gravity * (std::sin(30 * degree) - std::cos(30 * degree) * std::tan(10 * degree));
    EXPECT_NEAR(way_of(*settled), 0.5 * a * 0.04, 0.01 * 0.5 * a * 0.04);
}

TEST(SettleTimeStep, SaysNothingWhereBodiesDoNotSettle) {
    for (const char* word : {"settle_static=true", "settle_time_step=0.01", "settle_friction=1.0"}) {
        try {
            start(block_on_slope("planar_dda", 20, 30), {word});
            FAIL();
        } catch (const CaseError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("says nothing where bodies do not settle"));
        }
    }
}

}  // namespace
}  // namespace riprap::run
