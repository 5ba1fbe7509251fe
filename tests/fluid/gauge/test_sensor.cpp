// SPDX-License-Identifier: Apache-2.0
// What the area and the response of a sensor do to what it is shown.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "riprap/fluid/gauge/gauge.hpp"
#include "riprap/fluid/gauge/interpolate.hpp"

namespace riprap::fluid {
namespace {

TEST(Sensor, CountsRowsOfPointsExactlyWhateverItsSideAndWhereverTheyBegin) {
    constexpr double width = 0.1;
    for (const double side : {0.0, 1e-6, 0.03, 0.1, 0.37, 2.0}) {
        for (const double phase : {0.0, 0.013, 0.05}) {
            double sum = 0, square = 0;
            for (int k = -40; k <= 40; ++k) {
                const double x = k * width + phase, w = width * sensor_weight(x, width, side);
                sum += w;
                square += w * x * x;
            }
            EXPECT_NEAR(sum, 1, 1e-10) << side;
            // the variance of the spline, four uniform ones of the width, and that of the side
            EXPECT_NEAR(square, width * width / 3 + side * side / 12, 1e-9) << side;
        }
    }
}

TEST(Sensor, TakesTheSplineWhereItHasNoSideAndGoesOverIntoIt) {
    for (const double x : {0.0, 0.04, 0.11, 0.19}) {
        EXPECT_EQ(sensor_weight(x, 0.1, 0), spline_weight(x, 0.1));
        EXPECT_NEAR(sensor_weight(x, 0.1, 2e-4), spline_weight(x, 0.1), 2e-5) << x;
    }
    EXPECT_NEAR(sensor_weight(0.3, 0.1, 2), 0.5, 1e-15);  // well inside, every point counts 1/side
    EXPECT_EQ(sensor_weight(1.21, 0.1, 2), 0);
}

TEST(Sensor, ShowsAStepByOneLessAnExponentialAtAnyLengthOfStep) {
    for (const double dt : {1e-4, 1e-3, 7e-3}) {
        double shown = 0, time = 0;
        while (time < 0.03) {
            shown = lagged(shown, 5, dt, 0.01);
            time += dt;
            EXPECT_NEAR(shown, 5 * (1 - std::exp(-time / 0.01)), 1e-12) << dt;
        }
    }
}

// theta dy/dt = p - y with p = sin(w t): y = (sin(w t) - w theta cos(w t) + w theta exp(-t/theta))/(1 + (w theta)^2).
TEST(Sensor, LowersTheHalfSineOfAMillisecondByTheClosedFormAndKeepsItsImpulse) {
    constexpr double lasts = 1e-3, dt = 1e-7, w = std::numbers::pi / lasts;
    for (const double theta : {1e-3, 1e-2}) {
        double shown = 0, impulse = 0, of_load = 0;
        for (int k = 1; k <= 10'000; ++k) {
            const double load = std::sin(w * k * dt);
            shown = lagged(shown, load, dt, theta);
            of_load += dt * load;
            impulse += dt * shown;
        }
        const double c = w * theta, exact = (c + c * std::exp(-lasts / theta)) / (1 + c * c);
        EXPECT_NEAR(shown, exact, 2e-4) << theta;
        EXPECT_NEAR(impulse, of_load - theta * shown, 1e-4 * of_load) << theta;
    }
}

}  // namespace
}  // namespace riprap::fluid
