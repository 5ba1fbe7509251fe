// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "sim/small_scene.hpp"

namespace riprap::sim {
namespace {

using geometry::box;

/// A cube that flies alone; `end` and the step are what a test is about.
struct Flight : SmallScene {
    Scratch scratch;

    explicit Flight(double end) {
        add("cube", add_shape(box({1, 1, 1})), {}, body::Drive::free, {1, 0, 0});
        model.time.end = end;
        initialise(model, state);
    }
    TimeStep next() { return choose_time_step(model, state, scratch); }
    /// Steps to the end and returns the longest step.
    double fly() {
        double longest = 0;
        for (TimeStep step = next(); step.steps_left > 0; step = next()) {
            longest = std::max(longest, step.dt);
            EXPECT_TRUE(advance(model, state, scratch, step.dt, Measure::flow).status.ok());
        }
        return longest;
    }
};

TEST(ChooseTimeStep, AutomaticStepsMeetTheEndExactlyInAsFewEqualStepsAsAreAllowed) {
    for (const double end : {0.1, 0.3, 1.0 / 3, 1.0, 1.7, 10.0}) {
        Flight flight(end);
        const double allowed = flight.automatic_step();
        const auto steps = static_cast<std::int64_t>(std::ceil(end / allowed));
        EXPECT_EQ(flight.next().steps_left, steps);
        EXPECT_LE(flight.fly(), allowed * (1 + 1e-9));
        EXPECT_EQ(flight.state.time, end);
        EXPECT_EQ(flight.state.step, steps);
        EXPECT_NEAR(flight.state.bodies.position[0].x, end, 1e-12 * static_cast<double>(steps));
        EXPECT_NEAR(flight.state.previous_dt, end / static_cast<double>(steps), 1e-9 * allowed);
    }
}

TEST(ChooseTimeStep, AFixedStepKeepsItsLengthAndEndsAtOrAfterTheEnd) {
    Flight flight(1.0005);
    flight.model.time.time_step = 0.001;
    EXPECT_EQ(flight.next().steps_left, 1001);
    EXPECT_EQ(flight.fly(), 0.001);
    EXPECT_NEAR(flight.state.time, 1.001, 1e-15);
}

TEST(ChooseTimeStep, StepsAcrossForgiveRoundOff) {
    EXPECT_EQ(steps_across(1.0, 0.1), 10);  // 1.0 / 0.1 is not exactly 10 in every rounding
    EXPECT_EQ(steps_across(0.3, 0.1), 3);
    EXPECT_EQ(steps_across(1.0, 0.3), 4);
    EXPECT_EQ(steps_across(0.0, 0.3), 0);
    EXPECT_EQ(steps_across(-1.0, 0.3), 0);
    EXPECT_EQ(steps_across(1e12, 1e-9), 9'000'000'000'000'000'000);
}

// Summed plainly, a million steps of 0.1 ms miss 100 s by some 1e-9 s, ten thousandths of a step.
TEST(ChooseTimeStep, TimeCarriesNoRoundOffFromStepToStep) {
    SmallScene scene;
    scene.model.time.end = 1e9;
    initialise(scene.model, scene.state);
    Scratch scratch;
    for (int i = 0; i < 100'000; ++i) {
        advance(scene.model, scene.state, scratch, 0.1, Measure::flow);
    }
    EXPECT_EQ(scene.state.time, 1e4);
}

TEST(ChooseTimeStep, AHalvedStepIsDoubledAgainAfterAcceptedSteps) {
    Flight flight(1);
    const double whole = flight.next().dt;
    ASSERT_TRUE(halve_time_step(flight.model, flight.state));
    ASSERT_TRUE(halve_time_step(flight.model, flight.state));
    EXPECT_LE(flight.next().dt, whole / 4 * (1 + 1e-9));
    const auto steps = [&](std::int64_t count) {
        for (std::int64_t i = 0; i < count; ++i) {
            ASSERT_TRUE(advance(flight.model, flight.state, flight.scratch, flight.next().dt).status.ok());
        }
    };
    steps(steps_until_doubling - 1);
    EXPECT_EQ(flight.state.stepping.halvings, 2);
    steps(1);
    EXPECT_EQ(flight.state.stepping.halvings, 1);
    steps(steps_until_doubling);
    EXPECT_EQ(flight.state.stepping.halvings, 0);
    EXPECT_GT(flight.next().dt, 0.9 * whole);
    flight.fly();
    EXPECT_EQ(flight.state.time, 1);
}

TEST(ChooseTimeStep, AStepIsHalvedAStatedNumberOfTimesAndAFixedOneNever) {
    Flight flight(1);
    for (std::int64_t i = 0; i < max_halvings; ++i) {
        EXPECT_TRUE(halve_time_step(flight.model, flight.state));
    }
    EXPECT_FALSE(halve_time_step(flight.model, flight.state));
    flight.state.stepping = {};
    flight.model.time.time_step = 1e-3;
    EXPECT_FALSE(halve_time_step(flight.model, flight.state));
    EXPECT_EQ(flight.state.stepping.halvings, 0);
}

TEST(ChooseTimeStep, AFreshScratchChoosesTheSameStep) {
    Flight flight(1);
    for (int i = 0; i < 10; ++i) {
        Scratch fresh;
        const TimeStep step = flight.next();
        EXPECT_EQ(choose_time_step(flight.model, flight.state, fresh).dt, step.dt);
        advance(flight.model, flight.state, flight.scratch, step.dt);
    }
}

}  // namespace
}  // namespace riprap::sim
