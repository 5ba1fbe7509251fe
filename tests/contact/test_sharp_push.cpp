// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/sharp_push.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/narrowphase_support.hpp"
#include "riprap/contact/distance_potential_physics.hpp"

namespace riprap::contact {
namespace {

using namespace testing;

constexpr double pi = 3.14159265358979323846;

class SharpPushes : public ::testing::Test {
 protected:
    Pairs pairs;
    std::mt19937_64 random{7};
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    Block add(const geometry::Polyhedron& shape, const Pose& pose, double stiffness = 1) {
        return {pairs.shapes.add_convex(shape), pose, stiffness};
    }
    Block add_planar(const std::vector<geometry::Point2>& corners, const Pose& pose) {
        return {pairs.shapes.add_convex(geometry::planar_prism(corners).value(), true), pose, 1};
    }
    NormalContact meet(const Block& a, const Block& b, Corners corners = Corners::stiff) {
        const Frame frame_a = to_frame(a.pose), frame_b = to_frame(b.pose);
        DistancePotentialOptions options;
        options.corners = corners;
        SeparatingCache cache;
        NormalContact contact{};
        find_push({{pairs.shapes.view(a.shape), frame_a}, a.stiffness},
                  {{pairs.shapes.view(b.shape), frame_b}, b.stiffness}, options, cache, contact);
        return contact;
    }
};

TEST_F(SharpPushes, AreTheGradientOfTheirEnergyInAnyPosture) {
    const Block other = add(geometry::box({1.3, 1.1, 0.6}), {{0, 0, -0.3}, {}}, 0.7);
    int stiffened = 0;
    for (int i = 0; i < 200; ++i) {
        Block top =
            i % 2 == 0 ? add(geometry::box({1, 0.7, 0.4}), {}, 1.1) : add(geometry::prism(6, 0.5, 0.4).value(), {});
        const Quat turn = normalized(Quat{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
        top.pose = {{uniform(-0.8, 0.8), uniform(-0.7, 0.7), 0}, turn};
        double low = 0;
        for (int v = 0; v < pairs.shapes.view(top.shape).vertex_count; ++v) {
            low = std::min(low, rotate(turn, pairs.shapes.view(top.shape).vertex(v)).z);
        }
        top.pose.position.z = -low - uniform(0.002, 0.05);
        const NormalContact contact = meet(top, other);
        stiffened += norm(contact.force) > 1.5 * norm(meet(top, other, Corners::field).force) ? 1 : 0;
        const auto [force, moment] = energy_gradient(top.pose, 1e-5, [&](const Pose& pose) {
            return meet({top.shape, pose, top.stiffness}, other).energy;
        });
        expect_near(contact.force, force, 1e-5 * (1e-3 + norm(force)), "force");
        expect_near(moment_about(contact, top.pose.position), moment, 1e-5 * (1e-3 + norm(moment)), "moment");
        ASSERT_FALSE(HasFailure()) << "pair " << i;
    }
    EXPECT_GT(stiffened, 50);
}

// E_p = (k/r) d^3 (1/3 + 1/(3 sqrt 2)) for k and r alike, so E -> E_0^(1/3) E_p^(2/3): 1.73 k on each metre.
TEST_F(SharpPushes, OfASquareCornerInThePlaneIsASpring) {
    const std::vector<geometry::Point2> square{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    const Block floor = add_planar(square, {{0, -0.5, 0}, {}});
    Block block = add_planar(square, {});
    const Quat turn = from_rotation_vector({0, 0, pi / 4});
    const auto force = [&](double depth) {
        block.pose = {{0, std::sqrt(0.5) - depth, 0}, turn};
        return meet(block, floor).force.y;
    };
    const double energy = (1.0 / 3 + 1 / (3 * std::sqrt(2.0))) / 0.5;  // E_p/d^3
    const double spring = 2 * std::cbrt(2 * 0.25) * std::pow(energy, 2.0 / 3);
    // The field adds d/r to it, and the onset takes a little.
    EXPECT_NEAR(force(0.03) / (spring * 0.03 + 3 * energy * 0.03 * 0.03), 1, 0.08);
    EXPECT_NEAR(force(0.06) / (spring * 0.06 + 3 * energy * 0.06 * 0.06), 1, 0.02);
    // Where it is shallow it stays with the field.
    EXPECT_NEAR(force(5e-5) / (3 * energy * 2.5e-9), 1, 0.01);
    // Between: the derivative of E_p + E_0^(1/3) E_p^3 (E_p + E_1)^(-7/3), with E_1 = 0.005^3 E_0, E_0 = 2 (1/2)^2.
    const double d = 0.0025, e = energy * d * d * d, e0 = 0.5, e1 = e0 * 0.005 * 0.005 * 0.005;
    const double slope =
        std::cbrt(e0) * (3 * e * e * std::pow(e + e1, -7.0 / 3) - 7.0 / 3 * e * e * e * std::pow(e + e1, -10.0 / 3));
    EXPECT_NEAR(force(d) / (3 * energy * d * d * (1 + slope)), 1, 1e-9);
    EXPECT_GT(slope, 2);
}

TEST_F(SharpPushes, OfCrossingEdgesGrowAsTheSquareOfTheirDepth) {
    const Block low = add(geometry::box({2, 0.5, 0.5}), {{0, 0, 0}, from_rotation_vector({pi / 4, 0, 0})});
    Block high = add(geometry::box({0.5, 2, 0.5}), {});
    const auto force = [&](double depth) {
        high.pose = {{0.1, -0.1, std::sqrt(0.5) - depth}, from_rotation_vector({0, pi / 4, 0})};
        return meet(high, low).force.z;
    };
    EXPECT_NEAR(std::log(force(0.04) / force(0.02)) / std::log(2.0), 2, 0.15);
    EXPECT_GT(
        force(0.02), 4 * [&] { return meet(high, low, Corners::field).force.z; }());
}

TEST_F(SharpPushes, DoNotScaleWithTheSizeOfTheBlocks) {
    const Vec3 axis = Vec3{-1, 1, 0} / std::sqrt(2.0);
    double first = 0;
    for (const double s : {1e-3, 1.0, 1e3}) {
        const Block floor = add(geometry::cube(s), {{0, 0, -0.5 * s}, {}});
        const Block cube = add(geometry::cube(s), {{0, 0, 0.5 * s * (std::sqrt(3.0) - 0.04)},
                                                   from_rotation_vector(std::acos(-1 / std::sqrt(3.0)) * axis)});
        const double force = meet(cube, floor).force.z / (s * s);
        first = first > 0 ? first : force;
        EXPECT_GT(force, 2 * meet(cube, floor, Corners::field).force.z / (s * s));
        EXPECT_NEAR(force / first, 1, 1e-9) << s;
    }
}

// A floor many times as large and as stiff has little part in how a corner gives way: it never makes it softer.
TEST_F(SharpPushes, OfACornerGrowWithTheStiffnessOfALargeFloor) {
    const Vec3 axis = Vec3{-1, 1, 0} / std::sqrt(2.0);
    const Block cube = add(geometry::cube(1.0), {{0, 0, 0.5 * (std::sqrt(3.0) - 0.08)},
                                                 from_rotation_vector(std::acos(-1 / std::sqrt(3.0)) * axis)});
    double before = 0;
    for (const double stiffness : {1.0, 10.0, 100.0, 1000.0}) {
        const Block floor = add(geometry::box({400, 400, 200}), {{0, 0, -100}, {}}, stiffness);
        const double force = meet(cube, floor).force.z;
        EXPECT_GT(force, 1.2 * before) << stiffness;
        EXPECT_GT(force, 2 * meet(cube, floor, Corners::field).force.z) << stiffness;
        before = force;
    }
}

TEST_F(SharpPushes, LeaveFlatFacesAndRoundBodiesAsTheyAre) {
    const Block floor = add(geometry::box({1.3, 1.1, 0.6}), {{0, 0, -0.3}, {}});
    const Block cube = add(geometry::cube(0.4), {{0.5, 0, 0.199}, {}});
    EXPECT_EQ(meet(cube, floor).force, meet(cube, floor, Corners::field).force);
    const Block roller = add(geometry::prism(32, 0.3, 0.4).value(), {{0, 0, 0.29}, from_rotation_vector({1.5, 0, 0})});
    EXPECT_FALSE(pairs.shapes.view(roller.shape).is_sharp);
    EXPECT_EQ(meet(roller, floor).force, meet(roller, floor, Corners::field).force);
    EXPECT_TRUE(pairs.shapes.view(floor.shape).is_sharp);
}

// Twelve sides are 30 degrees apart, thirteen 27.7: no last digit of a corner may decide.
TEST_F(SharpPushes, AreThoseOfPrismsOfUpToTwelveSidesWhereverTheyCameFrom) {
    for (const double size : {1e-3, 0.3, 7.0}) {
        for (int k = 0; k < 40; ++k) {
            const Quat turn = normalized(Quat{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
            const auto is_sharp_prism = [&](int sides) {
                const geometry::Polyhedron prism = geometry::prism(sides, size, 0.4 * size).value();
                const Block moved = add(geometry::moved(prism, {{0, 0, 0}, turn}), {});
                std::vector<geometry::Point2> corners;
                for (int i = 0; i < sides; ++i) {
                    const double angle = 2 * pi * i / sides + 0.1 * k;
                    corners.push_back({size * std::cos(angle), size * std::sin(angle)});
                }
                const Block planar = add_planar(corners, {});
                EXPECT_EQ(pairs.shapes.view(moved.shape).is_sharp, pairs.shapes.view(planar.shape).is_sharp);
                return pairs.shapes.view(moved.shape).is_sharp;
            };
            EXPECT_TRUE(is_sharp_prism(12)) << size << " " << k;
            EXPECT_FALSE(is_sharp_prism(13)) << size << " " << k;
        }
    }
}

}  // namespace
}  // namespace riprap::contact
