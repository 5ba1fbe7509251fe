// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <random>
#include <vector>

#include "contact/narrowphase_support.hpp"

namespace riprap::contact {
namespace {

using namespace testing;

struct Golden {
    const char* name;
    geometry::Polyhedron a;
    Pose pose_a;
    geometry::Polyhedron b;
    double energy;
    double energy_tolerance;
    Vec3 force;
    Vec3 moment;
};

Quat turn(const Vec3& axis, double angle) { return from_rotation_vector(angle * normalized(axis)); }

/// Values of the exact prototype, k_n = 1 Pa, both sides, moments about the centre of A.
std::array<Golden, 4> golden_values() {
    using geometry::box, geometry::cube, geometry::regular_tetrahedron;
    return {
        {{"aligned cubes",
          cube(1),
          {{0.2, 0.1, 0.9}, {}},
          cube(1),
          0.0133,
          1e-15,
          {0.0173333333, 0.0153333333, 0.2553333333},
          {-0.0058666667, 0.0177333333, -0.0006666667}},
         {"turned cube",
          cube(1),
          {{0.1, 0.05, 1.05}, turn({1, 1, 0}, std::numbers::pi / 6)},
          cube(1),
          0.00391081523410,
          1e-14,
          {0.0014100194, 0, 0.0652695015},
          {-0.0082576783, -0.0091733908, 0.0002790609}},
         {"tetrahedron in a box",
          regular_tetrahedron(1),
          {{0.3, 0.1, 0.45}, turn({1, 2, 3}, 0.7)},
          box({2, 1, 0.5}),
          0.00665091276072,
          1e-14,
          {0, 0, 0.0810017635},
          {-0.0015770415, -0.0061905956, 0}},
         {"stacked cubes", cube(1), {{0, 0, 0.99}, {}}, cube(1), 1.97346666667e-4, 1e-15, {0, 0, 0.0392053333}, {}}}};
}

class DistancePotential : public ::testing::Test {
 protected:
    Pairs pairs;
    Block add(const geometry::Polyhedron& shape, const Pose& pose, double stiffness = 1) {
        return {pairs.shapes.add_convex(shape), pose, stiffness};
    }
};

TEST_F(DistancePotential, GivesTheGoldenValuesOfFourPairs) {
    for (const Golden& golden : golden_values()) {
        const Block a = add(golden.a, golden.pose_a), b = add(golden.b, {});
        for (const bool is_plain : {true, false}) {
            SCOPED_TRACE(std::string(golden.name) + (is_plain ? ", plain" : ", fast"));
            const NormalContact contact = is_plain ? pairs.plain(a, b) : pairs.fast(a, b);
            EXPECT_TRUE(pairs.is_touching);
            EXPECT_NEAR(contact.energy, golden.energy, golden.energy_tolerance);
            expect_near(contact.force, golden.force, 1e-10, "force");
            expect_near(moment_about(contact, golden.pose_a.position), golden.moment, 1e-10, "moment");
        }
    }
}

TEST_F(DistancePotential, IsTheGradientOfItsEnergyAtTheGoldenPairs) {
    for (const Golden& golden : golden_values()) {
        SCOPED_TRACE(golden.name);
        const Block a = add(golden.a, golden.pose_a), b = add(golden.b, {});
        const NormalContact contact = pairs.fast(a, b);
        const auto [force, moment] = energy_gradient(golden.pose_a, 1e-4, [&](const Pose& pose) {
            return pairs.fast({a.shape, pose, 1}, b).energy;
        });
        expect_near(contact.force, force, 1e-8, "force");
        expect_near(moment_about(contact, golden.pose_a.position), moment, 1e-8, "moment");
    }
}

/// Random blocks of 4 to 12 corners about one metre wide, and two placed so that they overlap in most draws.
class RandomBlocks : public DistancePotential {
 protected:
    std::mt19937_64 random{20240611};
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    Vec3 point(double radius) { return {uniform(-radius, radius), uniform(-radius, radius), uniform(-radius, radius)}; }
    Quat orientation() { return normalized(Quat{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}); }
    Block block() {
        const int corners = 4 + static_cast<int>(random() % 9);
        return add(geometry::random_hull(random(), corners, 0.5).value(), {point(0.35), orientation()},
                   uniform(0.5, 2));
    }
};

/// Force, moment and energy are sums of terms of the size of the force, times the length for the latter two, so
/// round-off is a share of that size however small the overlap is; positions are good to round-off of the blocks' size.
TEST_F(RandomBlocks, TheFastKernelAgreesWithTheOracleOnTenThousandTouchingPairs) {
    int touching = 0;
    std::vector<Block> stock;
    for (int i = 0; i < 100; ++i) {
        stock.push_back(block());
    }
    for (int i = 0; touching < 10'000; ++i) {
        ASSERT_LT(i, 20'000) << "too few of the pairs touch";
        Block a = stock[random() % stock.size()], b = stock[random() % stock.size()];
        a.pose = {point(0.35), orientation()};
        b.pose = {point(0.35), orientation()};
        pairs.options.sides = i % 4 == 0 ? Sides::contactor : Sides::both;
        pairs.options.potential = i % 3 == 0 ? Potential::fdem : Potential::distance;
        const NormalContact plain = pairs.plain(a, b);
        const bool plain_touches = pairs.is_touching;
        const NormalContact fast = pairs.fast(a, b);
        ASSERT_EQ(pairs.is_touching, plain_touches) << "pair " << i;
        if (pairs.is_touching) {
            ++touching;
            const double wall = std::min(flattest_wall(pairs.shapes.view(a.shape), pairs.options.potential),
                                         flattest_wall(pairs.shapes.view(b.shape), pairs.options.potential));
            expect_same(fast, plain, 1e-12, 1.0, wall);
            ASSERT_FALSE(HasFailure()) << "pair " << i;
        }
    }
}

}  // namespace
}  // namespace riprap::contact
