// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "riprap/run/simulate/schedule.hpp"

namespace riprap::run {
namespace {

/// Takes steps of the given lengths and returns the times at which the schedule was due, and then met.
std::vector<double> due_times(Schedule& schedule, const std::vector<double>& steps) {
    std::vector<double> due;
    double time = 0, dt = 0;
    for (std::size_t i = 0; i <= steps.size(); ++i) {
        if (schedule.is_due(time, dt)) {
            due.push_back(time);
            schedule.meet(time, dt);
        }
        dt = i < steps.size() ? steps[i] : 0;
        time += dt;
    }
    return due;
}

TEST(Schedule, EveryTimeIsMetAtTheFirstStepAtOrAfterIt) {
    const double dt = 0.3;
    Schedule schedule(1.0);
    const std::vector<double> due = due_times(schedule, std::vector<double>(1000, dt));
    ASSERT_EQ(due.size(), 301U);
    EXPECT_EQ(static_cast<double>(due.size()), due_count(1.0, dt, 1000));
    for (std::size_t k = 0; k < due.size(); ++k) {
        EXPECT_GE(due[k], static_cast<double>(k) - 1e-6);
        EXPECT_LT(due[k], static_cast<double>(k) + dt);
    }
}

TEST(Schedule, StepsOfAnyLengthMeetEveryTimeOnceAndSeveralTimesTogether) {
    Schedule schedule(1.0);
    const std::vector<double> due = due_times(schedule, {0.4, 0.4, 0.4, 2.5, 0.2, 0.1, 0.5, 0.5});
    const std::vector<double> expected{0, 1.2, 3.7, 4.0, 5.0};  // 2 and 3 lie within one step
    ASSERT_EQ(due.size(), expected.size());
    for (std::size_t k = 0; k < due.size(); ++k) {
        EXPECT_NEAR(due[k], expected[k], 1e-12);
    }
    EXPECT_EQ(schedule.next(), 6);
}

TEST(Schedule, AnIntervalBelowTheStepMeansEveryStep) {
    for (const double interval : {1e-6, 1e-300}) {
        Schedule schedule(interval);
        EXPECT_EQ(due_times(schedule, std::vector<double>(50, 1e-3)).size(), 51U);
        EXPECT_EQ(due_count(interval, 1e-3, 50), 51);
    }
}

TEST(Schedule, ATimeMissedByRoundOffIsMet) {
    Schedule schedule(0.1);
    EXPECT_EQ(due_times(schedule, std::vector<double>(1000, 0.1)).size(), 1001U);
}

TEST(Schedule, TheNextTimeIsAllThatARestartNeeds) {
    const std::vector<double> steps(500, 0.013);
    Schedule straight(0.1);
    const std::vector<double> whole = due_times(straight, steps);
    Schedule first(0.1);
    std::vector<double> parts;
    double time = 0;
    for (int i = 0; i <= 500; ++i, time += 0.013) {
        Schedule resumed(0.1, first.next());
        if (resumed.is_due(time, 0.013)) {
            parts.push_back(time);
            resumed.meet(time, 0.013);
        }
        first = resumed;
    }
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t k = 0; k < whole.size(); ++k) {
        EXPECT_NEAR(parts[k], whole[k], 1e-12);
    }
}

}  // namespace
}  // namespace riprap::run
