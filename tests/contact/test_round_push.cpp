// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/round_push.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "contact/narrowphase_support.hpp"
#include "riprap/contact/distance_potential_physics.hpp"

namespace riprap::contact {
namespace {

using namespace testing;

class RoundPushes : public ::testing::Test {
 protected:
    Pairs pairs;
    std::mt19937_64 random{11};
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    Quat any_turn() { return normalized(Quat{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}); }
    Block ball(double radius, const Vec3& at, double stiffness = 1) {
        return {pairs.shapes.add_convex(geometry::sphere(radius)), {at, any_turn()}, stiffness};
    }
    /// The prism of 64 sides with the area of a disc, turned by an angle.
    Block disc(double radius, const Vec3& at, double angle) {
        std::vector<geometry::Point2> corners;
        const double turn = std::numbers::pi / 32;
        for (int i = 0; i < 64; ++i) {
            const double reach = radius * std::sqrt(turn / std::sin(turn));
            corners.push_back({reach * std::cos(turn * i), reach * std::sin(turn * i)});
        }
        return {pairs.shapes.add_convex(geometry::planar_prism(corners).value(), true),
                {at, Quat{std::cos(angle / 2), 0, 0, std::sin(angle / 2)}},
                1};
    }
    bool touch(const Block& a, const Block& b, NormalContact& contact, Corners corners = Corners::stiff) {
        const Frame frame_a = to_frame(a.pose), frame_b = to_frame(b.pose);
        DistancePotentialOptions options;
        options.corners = corners;
        SeparatingCache cache;
        contact = {};
        return find_push({{pairs.shapes.view(a.shape), frame_a}, a.stiffness},
                         {{pairs.shapes.view(b.shape), frame_b}, b.stiffness}, options, cache, contact);
    }
};

TEST_F(RoundPushes, OfABallOnAFaceIsThatOfHertzHoweverItsFacetsLie) {
    const Block floor{pairs.shapes.add_convex(geometry::box({4, 4, 1})), {{0, 0, -0.5}, {}}, 3};
    const double r = 0.3, d = 0.002;
    for (int i = 0; i < 20; ++i) {
        NormalContact contact{};
        ASSERT_TRUE(touch(ball(r, {0.1, -0.2, r - d}), floor, contact));
        const double force = 4.0 / 3 * (1 + 3) * std::sqrt(r) * std::pow(d, 1.5);
        EXPECT_NEAR(contact.force.z, force, 1e-6 * force);
        EXPECT_NEAR(contact.energy, 0.4 * force * d, 1e-6 * force * d);
        EXPECT_NEAR(contact.stiffness, 1.5 * force / d, 1e-6 * force / d);
        EXPECT_NEAR(contact.spin_moment, 3 * std::numbers::pi / 16 * force * std::sqrt(r * d), 1e-6 * force);
        EXPECT_NEAR(contact.depth, d, 1e-9);
    }
    NormalContact above{};
    EXPECT_FALSE(touch(ball(r, {0.1, -0.2, r + 1e-6}), floor, above))
        << "corners of the polyhedron reach 1.2 % farther";
}

TEST_F(RoundPushes, OfADiscOnAFaceIsASpring) {
    const std::vector<geometry::Point2> corners{{-2, -1}, {2, -1}, {2, 0}, {-2, 0}};
    const Block floor{pairs.shapes.add_convex(geometry::planar_prism(corners).value(), true), {{0, -0.5, 0}, {}}, 1};
    for (const double angle : {0.0, 0.01, 0.049, 1.0}) {
        for (const double d : {1e-5, 1e-3}) {
            NormalContact contact{};
            ASSERT_TRUE(touch(disc(0.2, {0.3, 0.2 - d, 0}, angle), floor, contact)) << angle;
            const double force = std::numbers::pi / 4 * (1 + 1) * d;
            EXPECT_NEAR(contact.force.y, force, 1e-6 * force + 1e-12) << angle;
            EXPECT_NEAR(contact.force.x, 0, 1e-9 * force);
        }
    }
}

TEST_F(RoundPushes, AreTheGradientOfTheirEnergyOnFacesEdgesCornersAndEachOther) {
    const Block other{pairs.shapes.add_convex(geometry::box({1.3, 1.1, 0.6})), {{0, 0, -0.3}, {}}, 0.7};
    const Block round = ball(0.4, {0, 0, -0.4}, 0.9);
    int met = 0;
    for (int i = 0; i < 100; ++i) {
        const Block top = ball(0.25, {uniform(-0.8, 0.8), uniform(-0.7, 0.7), uniform(0.18, 0.25)}, 1.1);
        for (const Block& under : {other, round}) {
            NormalContact contact{};
            if (!touch(top, under, contact) || contact.depth < 1e-4) {
                continue;
            }
            ++met;
            const auto [force, moment] = energy_gradient(top.pose, 1e-6, [&](const Pose& pose) {
                NormalContact there{};
                return touch({top.shape, pose, top.stiffness}, under, there) ? there.energy : 0;
            });
            expect_near(contact.force, force, 1e-4 * (1e-3 + norm(force)), "force");
            expect_near(moment_about(contact, top.pose.position), {}, 1e-12, "no moment about the centre");
            ASSERT_FALSE(HasFailure()) << "pair " << i;
        }
    }
    EXPECT_GT(met, 60);
}

TEST_F(RoundPushes, LeaveThePublishedFieldWhereItIsAskedFor) {
    const Block floor{pairs.shapes.add_convex(geometry::box({4, 4, 1})), {{0, 0, -0.5}, {}}, 1};
    NormalContact field{}, round{};
    const Block top = ball(0.3, {0, 0, 0.29});
    ASSERT_TRUE(touch(top, floor, field, Corners::field));
    ASSERT_TRUE(touch(top, floor, round));
    EXPECT_LT(norm(field.force), 0.7 * norm(round.force));
}

}  // namespace
}  // namespace riprap::contact
