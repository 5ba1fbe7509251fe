// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/run/schedule.hpp"

namespace riprap::run {
namespace {

TEST(Schedule, EveryTimeIsMetAtTheNearestStepExactlyOnce) {
    const double dt = 0.3, interval = 1.0;
    const Schedule schedule(interval, dt);
    std::int64_t met = 0;
    for (std::int64_t step = 0; step <= 1000; ++step) {
        const std::int64_t k = schedule.due_at(step);
        if (k >= 0) {
            EXPECT_EQ(k, met++);
            EXPECT_LE(std::abs(static_cast<double>(step) * dt - static_cast<double>(k) * interval), 0.5 * dt + 1e-9);
        }
    }
    EXPECT_EQ(met, 301);
    EXPECT_EQ(schedule.due_count(1000), met);
}

TEST(Schedule, AnIntervalBelowTheStepMeansEveryStep) {
    const Schedule schedule(1e-6, 1e-3);
    for (std::int64_t step = 0; step < 50; ++step) {
        EXPECT_EQ(schedule.due_at(step), step);
    }
    EXPECT_EQ(schedule.due_count(49), 50);
}

TEST(Schedule, IntervalsThatAreNoMultipleOfTheStepNeverDrift) {
    const double dt = 1.0 / 3, interval = 0.1 * 7;
    const Schedule schedule(interval, dt);
    const std::int64_t far = schedule.step_of(1'000'000);
    EXPECT_NEAR(static_cast<double>(far) * dt, 1e6 * interval, 0.5 * dt + 1e-6);
    EXPECT_EQ(schedule.due_at(far), 1'000'000);
}

TEST(Steps, ARunEndsAtTheFirstStepAtOrAfterItsEnd) {
    EXPECT_EQ(count_steps(1.0, 0.1, -1), 10);  // 1.0 / 0.1 is not exactly 10 in every rounding
    EXPECT_EQ(count_steps(0.3, 0.1, -1), 3);
    EXPECT_EQ(count_steps(1.0, 0.3, -1), 4);
    EXPECT_EQ(count_steps(1.0, 0.3, 2), 2);
    EXPECT_EQ(count_steps(1.0, 0.3, 0), 0);
    EXPECT_EQ(count_steps(0.0, 0.3, -1), 0);
}

}  // namespace
}  // namespace riprap::run
