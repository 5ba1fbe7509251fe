// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/prescribed_motion.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace riprap::body {
namespace {

/// The stated velocities must be the time derivatives of the stated pose.
void expect_velocity_is_derivative_of_pose(const PrescribedMotion& motion, const Pose& initial, double time) {
    const double h = 1e-5;
    const DrivenState now = evaluate(motion, initial, time);
    const DrivenState before = evaluate(motion, initial, time - h), after = evaluate(motion, initial, time + h);
    const Vec3 velocity = (after.pose.position - before.pose.position) / (2 * h);
    const Vec3 turn = to_rotation_vector(after.pose.orientation * conjugate(before.pose.orientation));
    EXPECT_LT(norm(velocity - now.velocity), 1e-7);
    EXPECT_LT(norm(turn / (2 * h) - now.angular_velocity), 1e-7);
}

const Pose start{{1, 2, 3}, from_rotation_vector({0.2, 0.1, -0.4})};

TEST(PrescribedMotion, EveryLawStartsAtTheInitialPoseAndMovesAtItsStatedVelocity) {
    const PrescribedMotion motions[] = {
        {LinearMotion{{1, -2, 0.5}}},
        {SinusoidalMotion{{0.1, 0, 0.2}, 0.7, 0.3}},
        {SinusoidalMotion{{0.1, 0, 0.2}, 0.7, 0.3, 1.1}},
        {TableMotion{{0, 1, 3}, {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}}}},
        {RotatingMotion{{0, 0, 1}, {0, 0.6, 0.8}, 0.3, 0.1, 1.5, 0.2}},
        {RotatingMotion{{0, 0, 1}, {0, 0.6, 0.8}, 0.3, 0.1, 1.5, 0.2, 1.1}},
        {SplineMotion{{0, 1, 3}, {0, 0.4, -0.2}, {0.1, 0.5, 0}, {0.6, 0, 0.8}}},
        {SplineMotion{{0, 1, 3}, {0, 0.4, -0.2}, {0.1, 0.5, 0}, {0.6, 0, 0.8}, {0, 1, 0}, true}},
        {HarmonicMotion{.amplitude = {0.1, 0.03}, .angular_frequency = 4, .phase = 0.3, .ramp = 1}},
        {HarmonicMotion{.amplitude = {0.1, 0.03}, .angular_frequency = 4, .phase = 0.3}},
        {HarmonicMotion{.amplitude = {0.1}, .angular_frequency = 3, .direction = {0, 0.6, 0.8}, .arm = 0.5}},
    };
    for (const PrescribedMotion& motion : motions) {
        const DrivenState first = evaluate(motion, start, 0);
        EXPECT_LT(norm(first.pose.position - start.position), 1e-14);
        for (const double time : {0.2, 0.9, 2.1}) {
            expect_velocity_is_derivative_of_pose(motion, start, time);
        }
    }
}

TEST(PrescribedMotion, AnOscillationWithARampGrowsFromRestIntoThePlainSine) {
    const PrescribedMotion sine{SinusoidalMotion{{0.1, 0, 0}, 0.7, 0.3, 1.1}};
    const PrescribedMotion swing{RotatingMotion{{0, 0, 0}, {0, 0, 1}, 0, 0.1, 0.7, 0.3, 1.1}};
    EXPECT_NEAR(norm(evaluate(sine, Pose{}, 0).velocity), 0, 1e-15);
    EXPECT_NEAR(norm(evaluate(swing, Pose{}, 0).angular_velocity), 0, 1e-15);
    const double half =
        0.05 * std::sin(2 * std::numbers::pi * 0.55 / 0.7 + 0.3);  // half of its size at half of the ramp
    EXPECT_NEAR(evaluate(sine, Pose{}, 0.55).pose.position.x, half, 1e-15);
    const double angle = 2 * std::numbers::pi * 3 / 0.7 + 0.3, omega = 2 * std::numbers::pi / 0.7;
    EXPECT_NEAR(evaluate(sine, Pose{}, 3).pose.position.x, 0.1 * std::sin(angle), 1e-15);
    EXPECT_NEAR(evaluate(sine, Pose{}, 3).velocity.x, 0.1 * omega * std::cos(angle), 1e-14);
    EXPECT_NEAR(evaluate(swing, Pose{}, 3).angular_velocity.z, 0.1 * omega * std::cos(angle), 1e-14);
}

TEST(PrescribedMotion, ABodyRestsBeforeItsStartAndAfterItsStop) {
    const PrescribedMotion motion{LinearMotion{{2, 0, 0}}, 1.0, 3.0};
    EXPECT_EQ(evaluate(motion, start, 0.5).pose.position, start.position);
    EXPECT_EQ(evaluate(motion, start, 0.5).velocity, Vec3{});
    EXPECT_DOUBLE_EQ(evaluate(motion, start, 2).pose.position.x, start.position.x + 2);
    EXPECT_DOUBLE_EQ(evaluate(motion, start, 9).pose.position.x, start.position.x + 4);
    EXPECT_EQ(evaluate(motion, start, 9).velocity, Vec3{});
}

TEST(PrescribedMotion, AQuarterTurnAboutAnAxisMovesAPointAlongItsArc) {
    const PrescribedMotion motion{RotatingMotion{.center = {1, 0, 0}, .axis = {0, 0, 1}, .rate = 0.5}};
    const DrivenState turned = evaluate(motion, {{3, 0, 0}, {}}, std::numbers::pi);
    EXPECT_NEAR(turned.pose.position.x, 1, 1e-15);
    EXPECT_NEAR(turned.pose.position.y, 2, 1e-15);
    EXPECT_NEAR(turned.velocity.x, -1, 1e-15);
}

TEST(PrescribedMotion, ATableIsLinearBetweenRowsAndConstantBeyondThem) {
    const PrescribedMotion motion{TableMotion{{1, 2}, {{0, 0, 0}, {4, 0, 0}}}};
    EXPECT_EQ(evaluate(motion, Pose{}, 0.5).pose.position, Vec3{});
    EXPECT_EQ(evaluate(motion, Pose{}, 1.25).pose.position, (Vec3{1, 0, 0}));
    EXPECT_EQ(evaluate(motion, Pose{}, 7).pose.position, (Vec3{4, 0, 0}));
}

TEST(PrescribedMotion, ASplineReproducesACubicAndItsRate) {
    const auto cubic = [](double t) { return 2 - t + 3 * t * t - 0.5 * t * t * t; };
    const auto rate = [](double t) { return -1 + 6 * t - 1.5 * t * t; };
    SplineMotion law;
    for (const double t : {0.0, 0.7, 2.0}) {
        law.time.push_back(t);
        law.stroke.push_back(cubic(t));
        law.rate.push_back(rate(t));
    }
    for (const double t : {0.1, 0.69, 0.7, 1.3, 1.9}) {
        const DrivenState now = evaluate({law}, Pose{}, t);
        EXPECT_NEAR(now.pose.position.x, cubic(t), 1e-14);
        EXPECT_NEAR(now.velocity.x, rate(t), 1e-14);
    }
    EXPECT_EQ(evaluate({law}, Pose{}, 5).velocity, Vec3{});
    EXPECT_EQ(evaluate({law}, Pose{}, 5).pose.position.x, cubic(2.0));
}

TEST(PrescribedMotion, AnOscillationGoesOnForeverWithItsWholeStroke) {
    const PrescribedMotion motion{HarmonicMotion{.amplitude = {0.2}, .angular_frequency = 2, .ramp = 3}};
    const double late = 1000 * std::numbers::pi;
    EXPECT_NEAR(evaluate(motion, Pose{}, late + 0.25 * std::numbers::pi).pose.position.x, 0.2, 1e-12);
    EXPECT_NEAR(evaluate(motion, Pose{}, late).velocity.x, 0.4, 1e-12);
    EXPECT_EQ(evaluate(motion, Pose{}, 0).velocity, Vec3{});
}

}  // namespace
}  // namespace riprap::body
