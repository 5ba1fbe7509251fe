// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace riprap::fluid {
namespace {

/// Integral over the support by the midpoint rule in r, whose error falls with the square of the step.
template <class F>
double integrate(int dimension, double h, const F& f) {
    const int n = 20000;
    const double dr = 2 * h / n;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double r = (i + 0.5) * dr;
        sum += f(r) * (dimension == 2 ? 2 * std::numbers::pi * r : 4 * std::numbers::pi * r * r) * dr;
    }
    return sum;
}

class WendlandKernel : public testing::TestWithParam<int> {};

TEST_P(WendlandKernel, integrates_to_one) {
    const WendlandC2 kernel(0.3, GetParam());
    EXPECT_NEAR(integrate(GetParam(), 0.3, [&](double r) { return kernel.value(r); }), 1, 1e-8);
}

TEST_P(WendlandKernel, slope_is_the_derivative) {
    const WendlandC2 kernel(0.3, GetParam());
    for (const double r : {0.01, 0.1, 0.3, 0.45, 0.59}) {
        const double step = 1e-5;
        const double difference = (kernel.value(r + step) - kernel.value(r - step)) / (2 * step);
        EXPECT_NEAR(kernel.slope_over_r(r) * r, difference, 1e-7 * kernel.value(0.0) / 0.3) << r;
    }
}

TEST_P(WendlandKernel, slope_makes_a_linear_field_exact) {
    // the integral of x dW/dx over space is -1, so that of r^2 (dW/dr)/r is minus the dimension
    const WendlandC2 kernel(0.3, GetParam());
    EXPECT_NEAR(integrate(GetParam(), 0.3, [&](double r) { return kernel.slope_over_r(r) * r * r; }), -GetParam(),
                1e-7);
}

TEST_P(WendlandKernel, is_exactly_zero_at_and_beyond_its_support) {
    const WendlandC2 kernel(0.25, GetParam());
    for (const double r : {0.5, 0.50001, 1.0, 1e9}) {
        EXPECT_EQ(kernel.value(r), 0.0);
        EXPECT_EQ(kernel.slope_over_r(r), 0.0);
        EXPECT_EQ(kernel.value(static_cast<float>(r)), 0.0F);
    }
    EXPECT_GT(kernel.value(0.499), 0.0);
}

INSTANTIATE_TEST_SUITE_P(dimensions, WendlandKernel, testing::Values(2, 3));

}  // namespace
}  // namespace riprap::fluid
