// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/free_rotation.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace riprap::body {
namespace {

/// A torque-free body in its principal frame, advanced by rotate_free.
struct Top {
    Vec3 moments;
    Vec3 angular_momentum;
    Quat orientation{};

    void step(double dt) { orientation = rotate_free(orientation, angular_momentum, moments, Quat{}, dt); }
    Vec3 body_rates() const {
        const Vec3 local = rotate_back(orientation, angular_momentum);
        return {local.x / moments.x, local.y / moments.y, local.z / moments.z};
    }
    double energy() const {
        const Vec3 w = body_rates();
        return 0.5 * (moments.x * w.x * w.x + moments.y * w.y * w.y + moments.z * w.z * w.z);
    }
};

Top intermediate_axis_flip(const Vec3& rates) { return {{1, 2, 3}, {rates.x, 2 * rates.y, 3 * rates.z}, {}}; }

std::vector<double> zero_crossings_of_middle_rate(Top top, double dt, double end) {
    std::vector<double> crossings;
    double before = top.body_rates().y;
    for (double t = 0; t < end; t += dt) {
        top.step(dt);
        const double after = top.body_rates().y;
        if (before * after < 0) {
            crossings.push_back(t + dt * before / (before - after));
        }
        before = after;
    }
    return crossings;
}

// Crossing times from the elliptic integrals of Euler's equations for I = (1, 2, 3).
TEST(FreeRotation, AnIntermediateAxisFlipsAtTheEllipticIntegralsTimes) {
    const auto crossings = zero_crossings_of_middle_rate(intermediate_axis_flip({0.01, 1, 0.02}), 1e-3, 60);
    ASSERT_GE(crossings.size(), 3U);
    EXPECT_NEAR(crossings[0], 8.81336, 1e-4);
    EXPECT_NEAR(crossings[1] - crossings[0], 16.597498, 1e-4);
    EXPECT_NEAR(crossings[2] - crossings[1], 16.597498, 1e-4);

    const auto large = zero_crossings_of_middle_rate(intermediate_axis_flip({0.1, 1, 0.1}), 1e-3, 30);
    ASSERT_GE(large.size(), 2U);
    EXPECT_NEAR(large[0], 6.885703, 1e-4);
    EXPECT_NEAR(large[1] - large[0], 11.498131, 1e-4);
}

TEST(FreeRotation, EnergyOfATumblingBodyDoesNotDriftOverAHundredPeriods) {
    Top top = intermediate_axis_flip({0.01, 1, 0.02});
    EXPECT_NEAR(top.energy(), 1.00065, 1e-12);
    EXPECT_NEAR(norm(top.angular_momentum), 2.0009247862, 1e-10);
    const double start = top.energy();
    double worst = 0;
    const double dt = 1e-3, period = 33.194997;
    for (std::int64_t step = 0; step < static_cast<std::int64_t>(100 * period / dt); ++step) {
        top.step(dt);
        worst = std::max(worst, std::abs(top.energy() - start));
    }
    EXPECT_LT(worst, 1e-6 * start);
}

TEST(FreeRotation, ItsErrorFallsWithTheSquareOfTheStep) {
    const auto angle_error = [](double dt) {
        Top coarse = intermediate_axis_flip({0.3, 1, 0.2}), fine = coarse;
        for (int i = 0; i < static_cast<int>(std::round(4 / dt)); ++i) {
            coarse.step(dt);
        }
        for (int i = 0; i < 400000; ++i) {
            fine.step(1e-5);
        }
        return norm(to_rotation_vector(coarse.orientation * conjugate(fine.orientation)));
    };
    const double order = std::log2(angle_error(0.02) / angle_error(0.01));
    EXPECT_NEAR(order, 2.0, 0.1);
}

TEST(FreeRotation, ASpinAboutAPrincipalAxisIsExactAfterAThousandTurns) {
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 rates{};
        rates[axis] = 1;
        Top top = intermediate_axis_flip(rates);
        const int steps_per_turn = 100;
        const double dt = 2 * std::numbers::pi / steps_per_turn;
        for (int step = 0; step < 1000 * steps_per_turn; ++step) {
            top.step(dt);
        }
        EXPECT_LT(norm(to_rotation_vector(top.orientation)), 1e-10) << "axis " << axis;
    }
}

TEST(FreeRotation, ASymmetricTopPrecessesExactlyAtAnyStep) {
    // omega_3 = const, the transverse rates turn at (I3 - I1)/I1 omega_3 in the body frame.
    for (int odd = 0; odd < 3; ++odd) {
        Vec3 moments{2, 2, 2}, rates{0.3, 0.3, 0.3};
        moments[odd] = 5;
        Top top{moments, {moments.x * rates.x, moments.y * rates.y, moments.z * rates.z}, {}};
        const double end = 7;
        for (int i = 0; i < 3; ++i) {
            top.step(end / 3);
        }
        const double turn = (5.0 - 2.0) / 2.0 * rates[odd] * end;
        const int first = (odd + 1) % 3, second = (odd + 2) % 3;
        const Vec3 w = top.body_rates();
        EXPECT_NEAR(w[odd], 0.3, 1e-14);
        EXPECT_NEAR(w[first], 0.3 * (std::cos(turn) - std::sin(turn)), 1e-13);
        EXPECT_NEAR(w[second], 0.3 * (std::sin(turn) + std::cos(turn)), 1e-13);
    }
}

TEST(FreeRotation, ReversedMomentumLeadsBackToTheStart) {
    Top top = intermediate_axis_flip({0.5, 1, 0.2});
    for (int i = 0; i < 10000; ++i) {
        top.step(1e-2);
    }
    top.angular_momentum = -top.angular_momentum;
    for (int i = 0; i < 10000; ++i) {
        top.step(1e-2);
    }
    EXPECT_LT(norm(to_rotation_vector(top.orientation)), 1e-10);
}

TEST(FreeRotation, PrincipalAxesTurnedInTheBodyChangeNothingInSpace) {
    const Quat axes = from_rotation_vector({0.3, -0.8, 0.4});
    const Vec3 moments{1, 2, 3}, momentum{0.4, 1.1, -0.7};
    const Quat frame = from_rotation_vector({1, 0.2, 0.1});
    Quat direct = frame, through_axes = frame * conjugate(axes);
    for (int i = 0; i < 100; ++i) {
        direct = rotate_free(direct, momentum, moments, Quat{}, 0.05);
        through_axes = rotate_free(through_axes, momentum, moments, axes, 0.05);
    }
    EXPECT_LT(norm(to_rotation_vector(through_axes * axes * conjugate(direct))), 1e-12);
}

}  // namespace
}  // namespace riprap::body
