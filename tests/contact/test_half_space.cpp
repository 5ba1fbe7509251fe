// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "contact/narrowphase_support.hpp"

namespace riprap::contact {
namespace {

using namespace testing;

class HalfSpace : public ::testing::Test {
 protected:
    Pairs pairs;
    Block ground{pairs.shapes.add_half_space({0, 0, 1}, 0), {}, 1};
    Block add(const geometry::Polyhedron& shape, const Pose& pose, double stiffness = 1) {
        return {pairs.shapes.add_convex(shape), pose, stiffness};
    }
    const Pose tilted{{0.3, -2, 0.4}, from_rotation_vector({0.4, 0.2, 0.9})};
};

TEST_F(HalfSpace, CarriesABlockByTheFieldOfTheBlockAlone) {
    // Flat on the ground: phi = depth / r on the cut but for the edges, F = k/r (a^2 d - 4 a d^2 / 2 + 4 d^3 / 3).
    const double d = 0.01, k = 5;
    const Block cube = add(geometry::cube(1), {{3, 4, 0.5 - d}, {}}, k);
    const NormalContact contact = pairs.fast(cube, ground);
    ASSERT_TRUE(pairs.is_touching);
    expect_near(contact.force, {0, 0, k / 0.5 * (d - 2 * d * d + 4 * d * d * d / 3)}, 1e-15, "force");
    EXPECT_NEAR(contact.area, 1, 1e-14);
    EXPECT_NEAR(contact.stiffness, k / 0.5, 1e-12);
    expect_near(contact.point, {3, 4, 0}, 1e-12, "point");
    EXPECT_NEAR(contact.energy, k / 0.5 * (d * d / 2 - 2 * d * d * d / 3 + d * d * d * d / 3), 1e-16);
}

TEST_F(HalfSpace, PushesWithTheGradientOfItsEnergyInAnyAttitude) {
    const Block block = add(geometry::box({2, 1, 0.5}), tilted);
    const NormalContact contact = pairs.fast(block, ground);
    ASSERT_TRUE(pairs.is_touching);
    const auto [force, moment] = energy_gradient(block.pose, 1e-4, [&](const Pose& pose) {
        return pairs.fast({block.shape, pose, 1}, ground).energy;
    });
    expect_near(contact.force, force, 1e-8, "force");
    expect_near(moment_about(contact, block.pose.position), moment, 1e-8, "moment");
}

TEST_F(HalfSpace, AgreesWithTheOracleOnEitherSideOfThePair) {
    const Block block = add(geometry::dodecahedron(0.5), tilted, 2);
    const NormalContact contact = pairs.fast(block, ground);
    ASSERT_TRUE(pairs.is_touching);
    expect_same(contact, pairs.plain(block, ground), 1e-12, 1);
    const NormalContact swapped = pairs.fast(ground, block);
    expect_same(swapped, pairs.plain(ground, block), 1e-12, 1);
    expect_near(swapped.force, -contact.force, 1e-15, "force");
    EXPECT_NEAR(swapped.energy, contact.energy, 1e-15);
}

TEST_F(HalfSpace, IsTheLimitOfAHugeBlockThatHasNoFieldOfItsOwn) {
    const Block block = add(geometry::cube(1), {{0, 0, 0.6}, from_rotation_vector({0.4, 0.2, 0.9})});
    const NormalContact limit = pairs.fast(block, ground);
    double error = 0;
    for (const double size : {1e2, 1e3}) {
        // Of a block of size L the field is h/(L/2): its share falls as 1/L.
        const Block huge = add(geometry::cube(size), {{0, 0, -size / 2}, {}});
        const double now = norm(pairs.fast(block, huge).force - limit.force) / norm(limit.force);
        EXPECT_LT(now, 3 / size);
        EXPECT_TRUE(error == 0 || now < 0.11 * error);
        error = now;
    }
}

TEST_F(HalfSpace, LeavesABlockAboveItAlone) {
    pairs.fast(add(geometry::cube(1), {{0, 0, 0.5001}, {}}), ground);
    EXPECT_FALSE(pairs.is_touching);
    pairs.fast(ground, ground);
    EXPECT_FALSE(pairs.is_touching);
}

/// A box in two parts with an internal face at x = cut; both with the radius of the whole.
struct SplitBox {
    std::array<ShapeId, 2> shape;
    std::array<Vec3, 2> centre;
};

class InternalFaces : public HalfSpace {
 protected:
    static constexpr Vec3 size{2, 1, 1};
    SplitBox split(double cut) {
        SplitBox parts{};
        for (std::size_t i = 0; i < 2; ++i) {
            const double low = i == 0 ? -size.x / 2 : cut, high = i == 0 ? cut : size.x / 2;
            geometry::Polyhedron part = geometry::box({high - low, size.y, size.z});
            for (Vec3& x : part.vertices) {
                x.x += (low + high) / 2;
            }
            part.is_internal.assign(part.faces.size(), 0);
            for (std::size_t f = 0; f < part.faces.size(); ++f) {
                bool lies_in_cut = true;
                for (const auto v : part.faces[f]) {
                    lies_in_cut = lies_in_cut && std::abs(part.vertices[static_cast<std::size_t>(v)].x - cut) < 1e-12;
                }
                part.is_internal[f] = lies_in_cut ? 1 : 0;
            }
            parts.shape[i] = pairs.shapes.add_convex(part, false, &parts.centre[i]);
        }
        return parts;
    }
    /// Force, moment about the origin and energy on `a` from both parts.
    struct Sum {
        Vec3 force, moment;
        double energy{0};
    };
    Sum on(const Block& a, const SplitBox& parts, const Pose& pose = {}, bool is_plain = false) {
        Sum sum;
        for (std::size_t i = 0; i < 2; ++i) {
            const Block part{parts.shape[i], {to_world(pose, parts.centre[i]), pose.orientation}, 1};
            const NormalContact contact = is_plain ? pairs.plain(a, part) : pairs.fast(a, part);
            sum.force += contact.force;
            sum.moment += pairs.is_touching ? moment_about(contact, {}) : Vec3{};
            sum.energy += contact.energy;
        }
        return sum;
    }
    Block ball() { return add(geometry::icosahedron(0.4), {{0.1, 0.2, 0.7}, from_rotation_vector({0.3, 0.2, 0.1})}); }
};

TEST_F(InternalFaces, ABoxCutInTheMiddleActsAsTheWholeBox) {
    // Beyond the middle the far end is never the nearest face, and both parts have the whole's radius: same field.
    const Block probe = ball();
    const Block whole = add(geometry::box(size), {});
    const SplitBox halves = split(0);
    for (const bool is_plain : {true, false}) {
        const Sum sum = on(probe, halves, {}, is_plain);
        const NormalContact one = is_plain ? pairs.plain(probe, whole) : pairs.fast(probe, whole);
        ASSERT_TRUE(pairs.is_touching);
        expect_near(sum.force, one.force, 1e-14, "force");
        expect_near(sum.moment, moment_about(one, {}), 1e-14, "moment");
        EXPECT_NEAR(sum.energy, one.energy, 1e-14);
    }
}

TEST_F(InternalFaces, ABoxCutAnywherePushesWithTheGradientOfTheSumOfItsEnergies) {
    const Block probe = ball();
    const SplitBox parts = split(0.23);
    const Sum sum = on(probe, parts);
    const auto [force, moment] = energy_gradient(probe.pose, 1e-4, [&](const Pose& pose) {
        return on({probe.shape, pose, 1}, parts).energy;
    });
    expect_near(sum.force, force, 1e-8, "force");
    expect_near(sum.moment - cross(probe.pose.position, sum.force), moment, 1e-8, "moment");
}

TEST_F(InternalFaces, PrismsOneUnitThickGiveTheFieldOfThePlane) {
    // Squares of side a, edges aligned, overlap d: F = k (1/r_A + 1/r_B) (a d - d^2) per unit thickness, r = a/2.
    const double a = 0.8, d = 0.02;
    const std::array<geometry::Point2, 4> corners{{{-a / 2, -a / 2}, {a / 2, -a / 2}, {a / 2, a / 2}, {-a / 2, a / 2}}};
    const ShapeId square = pairs.shapes.add_convex(geometry::planar_prism(corners).value(), true);
    for (const bool is_plain : {true, false}) {
        const Block upper{square, {{0, a - d, 0}, {}}, 1}, lower{square, {}, 1};
        const NormalContact contact = is_plain ? pairs.plain(upper, lower) : pairs.fast(upper, lower);
        ASSERT_TRUE(pairs.is_touching);
        expect_near(contact.force, {0, 4 / a * (a * d - d * d), 0}, 1e-14, "force");
        EXPECT_NEAR(contact.energy, 4 / a * (a * d * d / 2 - d * d * d / 3), 1e-15);
        EXPECT_NEAR(contact.area, a, 1e-13);
        EXPECT_EQ(contact.point.z, 0);
        EXPECT_EQ(contact.force.z, 0);
    }
}

TEST_F(InternalFaces, TurnedPrismsPushWithTheGradientOfTheirEnergyInThePlane) {
    const auto shape = [&](int sides) {
        std::vector<geometry::Point2> corners;
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * 3.14159265358979323846 * (i + 0.3 * (i % 2)) / sides;
            corners.push_back({0.5 * std::cos(angle), 0.5 * std::sin(angle)});
        }
        return pairs.shapes.add_convex(geometry::planar_prism(corners).value(), true);
    };
    const Block a{shape(7), {{0.4, 0.5, 0}, from_rotation_vector({0, 0, 0.4})}, 1}, b{shape(5), {}, 2};
    const NormalContact contact = pairs.fast(a, b);
    ASSERT_TRUE(pairs.is_touching);
    expect_same(contact, pairs.plain(a, b), 1e-12, 1);
    const double h = 1e-5;
    const auto energy = [&](const Pose& pose) { return pairs.fast({a.shape, pose, 1}, b).energy; };
    const auto slope = [&](const Pose& up, const Pose& down) { return -(energy(up) - energy(down)) / (2 * h); };
    EXPECT_NEAR(contact.force.x, slope(moved(a.pose, {h, 0, 0}), moved(a.pose, {-h, 0, 0})), 1e-8);
    EXPECT_NEAR(contact.force.y, slope(moved(a.pose, {0, h, 0}), moved(a.pose, {0, -h, 0})), 1e-8);
    EXPECT_NEAR(moment_about(contact, a.pose.position).z, slope(turned(a.pose, {0, 0, h}), turned(a.pose, {0, 0, -h})),
                1e-8);
}

}  // namespace
}  // namespace riprap::contact
