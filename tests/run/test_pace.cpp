// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/run/drive/pace.hpp"

namespace riprap::run {
namespace {

constexpr double end = 10;  // [s]

/// Steps of a run from `begin` on, each of `dt` at `seconds` of wall-clock time.
struct Course {
    Pace& pace;
    double time{0}, clock{0};
    std::int64_t step{0}, max_steps{-1};
    void go(int count, double dt, double seconds) {
        for (int i = 0; i < count; ++i) {
            time += dt;
            clock += seconds;
            pace.note({++step, time, end, max_steps}, clock);
        }
    }
};

TEST(Pace, OfARunWhoseStepsAreAllAlikeIsExactFromTheFirstStepOn) {
    Pace pace({0, 0, end});
    EXPECT_FALSE(std::isfinite(pace.seconds_left()));
    Course course{pace};
    course.go(1, 0.01, 0.002);
    EXPECT_NEAR(pace.seconds_left(), 2 - 0.002, 1e-12);
    course.go(399, 0.01, 0.002);
    EXPECT_NEAR(pace.seconds_left(), 1.2, 1e-9);
    EXPECT_NEAR(pace.seconds_per_step(), 0.002, 1e-12);
}

TEST(Pace, FollowsStepsThatGetShorterAndDearerWithinATenthOfTheRun) {
    Pace pace({0, 0, end});
    Course course{pace};
    course.go(500, 0.01, 0.001);    // half of the run in half a second
    course.go(1000, 0.001, 0.004);  // a tenth in 4 s: 40 s for a run
    EXPECT_NEAR(pace.seconds_left(), 4 * 4.0, 1e-6);
}

TEST(Stand, CountsSimulatedTimeNotStepsWhoseLengthChanges) {
    EXPECT_DOUBLE_EQ((Stand{1'000'000, 2.5, end}.share()), 0.25);
    EXPECT_DOUBLE_EQ((Stand{3, end, end}.share()), 1);
}

TEST(Stand, IsThatOfMaxStepsWhereTheseEndTheRunFirst) {
    EXPECT_DOUBLE_EQ((Stand{50, 0.1, end, 100}.share()), 0.5);
    EXPECT_DOUBLE_EQ((Stand{1, 9, end, 100}.share()), 0.9);
    Pace pace({0, 0, end, 100});
    Course course{pace, 0, 0, 0, 100};
    course.go(50, 0.001, 0.1);
    EXPECT_NEAR(pace.seconds_left(), 5, 1e-9);
    EXPECT_NEAR(pace.seconds_to_end(), (end - 0.05) / 0.001 * 0.1, 1e-6);
}

TEST(Pace, OfAResumedRunIsThatOfItsOwnProcess) {
    Pace pace({800, 8, end});
    Course course{pace, 8, 0, 800};
    course.go(100, 0.01, 0.01);
    EXPECT_NEAR(pace.seconds_left(), 1, 1e-9);
    EXPECT_NEAR(pace.share_of_process(), 0.5, 1e-9);
    EXPECT_NEAR(pace.seconds_per_step(), 0.01, 1e-12);
}

TEST(Pace, KeepsCountingTheTimeOfStepsThatWereTakenBack) {
    Pace pace({0, 0, end});
    Course course{pace};
    course.go(100, 0.01, 0.01);
    course.time = 0.5;
    course.go(50, 0.01, 0.01);
    EXPECT_GT(pace.seconds_left(), 9 / 0.01 * 0.01 - 1e-9);
    EXPECT_LT(pace.seconds_left(), 4 * 9.0);
}

}  // namespace
}  // namespace riprap::run
