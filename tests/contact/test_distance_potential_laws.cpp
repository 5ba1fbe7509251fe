// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <numbers>
#include <random>
#include <vector>

#include "contact/narrowphase_support.hpp"

namespace riprap::contact {
namespace {

using namespace testing;

class ContactLaws : public ::testing::Test {
 protected:
    Pairs pairs;
    std::mt19937_64 random{7};
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    Vec3 point(double radius) { return {uniform(-radius, radius), uniform(-radius, radius), uniform(-radius, radius)}; }
    Quat orientation() { return normalized(Quat{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}); }
    Block add(const geometry::Polyhedron& shape, const Pose& pose, double stiffness = 1) {
        return {pairs.shapes.add_convex(shape), pose, stiffness};
    }
    Block hull(int corners) {
        return add(geometry::random_hull(random(), corners, 0.5).value(), {point(0.3), orientation()}, uniform(0.5, 2));
    }
};

TEST_F(ContactLaws, ForceAndMomentAreTheGradientOfTheEnergyForRandomBlocksWithUnequalStiffness) {
    int touching = 0;
    for (int i = 0; i < 200 || touching < 200; ++i) {
        ASSERT_LT(i, 1000);
        pairs.options.sides = i % 5 == 0 ? Sides::contactor : Sides::both;
        const Block a = hull(4 + i % 9), b = hull(4 + i % 7);
        const NormalContact contact = pairs.fast(a, b);
        if (!pairs.is_touching) {
            continue;
        }
        ++touching;
        const auto [force, moment] = energy_gradient(a.pose, 5e-5, [&](const Pose& pose) {
            return pairs.fast({a.shape, pose, a.stiffness}, b).energy;
        });
        expect_near(contact.force, force, 1e-6 * (1e-2 + norm(force)), "force");
        expect_near(moment_about(contact, a.pose.position), moment, 1e-6 * (1e-2 + norm(moment)), "moment");
        ASSERT_FALSE(HasFailure()) << "pair " << i;
    }
}

TEST_F(ContactLaws, MovingAndTurningBothBlocksTurnsTheWrenchWithThem) {
    for (int i = 0; i < 100; ++i) {
        const Block a = hull(8), b = hull(9);
        const NormalContact before = pairs.fast(a, b);
        if (!pairs.is_touching || norm(before.force) < 1e-6) {
            continue;
        }
        const Pose move{point(5), orientation()};
        const auto carried = [&](const Block& block) {
            return Block{block.shape,
                         {to_world(move, block.pose.position), normalized(move.orientation * block.pose.orientation)},
                         block.stiffness};
        };
        const NormalContact after = pairs.fast(carried(a), carried(b));
        const double force = norm(before.force);
        expect_near(after.force, rotate(move.orientation, before.force), 1e-12 * (1 + force), "force");
        expect_near(after.moment, rotate(move.orientation, before.moment), 1e-12 * (1 + force), "moment");
        expect_near(after.point, to_world(move, before.point), 1e-9, "point");
        EXPECT_NEAR(after.energy, before.energy, 1e-13);
        EXPECT_NEAR(after.area, before.area, 1e-12);
    }
}

TEST_F(ContactLaws, ExchangingTheBlocksReversesTheForceAndKeepsEverythingElse) {
    for (int i = 0; i < 200; ++i) {
        const Block a = hull(8), b = hull(5);
        const NormalContact ab = pairs.fast(a, b);
        if (!pairs.is_touching || norm(ab.force) < 1e-6) {
            continue;
        }
        const NormalContact ba = pairs.fast(b, a);
        expect_near(ba.force, -ab.force, 1e-14, "force");
        expect_near(moment_about(ba, {}), -moment_about(ab, {}), 1e-14, "moment");
        EXPECT_NEAR(ba.energy, ab.energy, 1e-14);
        EXPECT_NEAR(ba.area, ab.area, 1e-14);
        EXPECT_NEAR(ba.stiffness, ab.stiffness, 1e-13);
    }
}

TEST_F(ContactLaws, EnergyForceAndMomentScaleWithTheThirdSecondAndThirdPowerOfSize) {
    const double scale = 7.5;
    const geometry::Polyhedron shape = geometry::random_hull(3, 10, 0.5).value();
    geometry::Polyhedron large = shape;
    for (Vec3& x : large.vertices) {
        x *= scale;
    }
    const Pose at{{0.3, 0.2, 0.4}, orientation()};
    const NormalContact one = pairs.fast(add(shape, at), add(shape, {}));
    ASSERT_TRUE(pairs.is_touching);
    const NormalContact many = pairs.fast(add(large, {scale * at.position, at.orientation}), add(large, {}));
    EXPECT_NEAR(many.energy, scale * scale * scale * one.energy, 1e-12 * many.energy);
    EXPECT_NEAR(norm(many.force - scale * scale * one.force), 0, 1e-12 * norm(many.force));
    EXPECT_NEAR(norm(many.moment - scale * scale * scale * one.moment), 0, 1e-11 * norm(many.force));
    EXPECT_NEAR(many.potential, one.potential, 1e-12);
}

TEST_F(ContactLaws, TheVectorAreasOfBothPatchesCancel) {
    for (int i = 0; i < 200; ++i) {
        const Block a = hull(8), b = hull(7);
        const geometry::ConvexView va = pairs.shapes.view(a.shape), vb = pairs.shapes.view(b.shape);
        const Frame fa = to_frame(a.pose), fb = to_frame(b.pose);
        SurfaceWorkspace work;
        SurfaceIntegrals on_a{}, on_b{};
        const Frame a_in_b = plain::relative_frame(fa, fb), b_in_a = plain::relative_frame(fb, fa);
        integrate_surface({va, a_in_b, vb, Potential::distance, {}, 1e-14, false, work}, on_a);
        integrate_surface({vb, b_in_a, va, Potential::distance, {}, 1e-14, false, work}, on_b);
        EXPECT_NEAR(norm(fb.axes * on_a.area + fa.axes * on_b.area), 0, 1e-13) << "pair " << i;
    }
}

TEST_F(ContactLaws, AnUprightCornerOnAFaceGivesTheClosedFormForce) {
    // The tip is a tetrahedron of height d and volume c d^3. Over it the depth below the slab's face has the mean d/4,
    // that below the nearest of the other three faces 1/12 of their altitude: sqrt(3) d for a cube, d for a regular
    // tetrahedron.
    struct Corner {
        geometry::Polyhedron shape;
        Vec3 tip;           ///< the corner that points down
        double radius;      ///< inscribed
        double volume;      ///< c
        double face_depth;  ///< mean depth below the nearest face of the corner, over d
    };
    const double sqrt3 = std::sqrt(3.0), slab_radius = 0.5;
    const std::array<Corner, 2> corners{{{geometry::cube(1), {0.5, 0.5, 0.5}, 0.5, sqrt3 / 2, sqrt3 / 12},
                                         {geometry::regular_tetrahedron(1),
                                          {1, 1, 1},
                                          1 / std::sqrt(24.0),
                                          std::pow(1.5, 1.5) / (6 * std::sqrt(2.0)),
                                          1.0 / 12}}};
    for (const Corner& corner : corners) {
        const Vec3 up{0, 0, 1}, axis = cross(normalized(corner.tip), -up);
        const Quat upright = from_rotation_vector(std::acos(dot(normalized(corner.tip), -up)) * normalized(axis));
        const double reach = corner.shape.vertices.empty() ? 0 : std::sqrt(norm_squared(corner.shape.vertices[0]));
        const double depth = 0.05;
        const Block slab = add(geometry::box({4, 4, 1}), {{0, 0, -0.5}, {}});
        const Block block = add(corner.shape, {{0, 0, reach - depth}, upright});
        const NormalContact contact = pairs.fast(block, slab);
        const double energy =
            corner.volume * std::pow(depth, 4) * (0.25 / slab_radius + corner.face_depth / corner.radius);
        EXPECT_NEAR(contact.energy, energy, 1e-12 * energy);
        EXPECT_NEAR(contact.force.z, 4 * energy / depth, 1e-10 * energy / depth);
        EXPECT_NEAR(contact.potential, depth / slab_radius, 1e-12);
    }
}

TEST_F(ContactLaws, CrossedRidgesGiveTheClosedFormForce) {
    // A: y >= -d + p |x|; B: y <= -q |z|; E = k d^4 / (6 p q) [1/(r_B sqrt(1+q^2)) + 1/(r_A sqrt(1+p^2))].
    const double p = 0.8, q = 1.3, d = 0.01;
    const auto upright = geometry::tetrahedron({-1, p, 0}, {1, p, 0}, {0, 0, -1}, {0, 0, 1}).value();
    const auto hanging = geometry::tetrahedron({0, -q, -1}, {0, -q, 1}, {-1, 0, 0}, {1, 0, 0}).value();
    Vec3 centre_a, centre_b;
    const ShapeId a = pairs.shapes.add_convex(upright, false, &centre_a);
    const ShapeId b = pairs.shapes.add_convex(hanging, false, &centre_b);
    const double ra = pairs.shapes.view(a).inscribed_radius, rb = pairs.shapes.view(b).inscribed_radius;
    const NormalContact contact = pairs.fast({a, {centre_a - Vec3{0, d, 0}, {}}}, {b, {centre_b, {}}});
    const double energy =
        std::pow(d, 4) / (6 * p * q) * (1 / (rb * std::sqrt(1 + q * q)) + 1 / (ra * std::sqrt(1 + p * p)));
    EXPECT_NEAR(contact.energy, energy, 1e-12 * energy);
    expect_near(contact.force, {0, 4 * energy / d, 0}, 1e-12 * 4 * energy / d, "force");
    EXPECT_NEAR(norm(moment_about(contact, {})), 0, 1e-14 * energy / d);
}

TEST_F(ContactLaws, AFaceOnAFaceLosesForceAtItsEdgesAsInTheClosedForm) {
    // F = k (1/r_A + 1/r_B) (a^2 d - 2 a d^2 + 4 d^3 / 3) for a square of side a with both edges aligned.
    const double side = 0.7, d = 0.03, ka = 2, kb = 3;
    const geometry::Polyhedron cube = geometry::cube(side);
    const NormalContact contact = pairs.fast(add(cube, {{0, 0, side - d}, {}}, ka), add(cube, {}, kb));
    const double stiffness = (ka + kb) / (side / 2);
    const double force = stiffness * (side * side * d - 2 * side * d * d + 4 * d * d * d / 3);
    const double energy = stiffness * (side * side * d * d / 2 - 2 * side * d * d * d / 3 + d * d * d * d / 3);
    expect_near(contact.force, {0, 0, force}, 1e-13, "force");
    EXPECT_NEAR(contact.energy, energy, 1e-14);
    EXPECT_NEAR(contact.area, side * side, 1e-14);
    EXPECT_NEAR(contact.stiffness, stiffness * side * side, 1e-12);
    EXPECT_NEAR(contact.depth, d, 1e-15);
    EXPECT_NEAR(contact.potential, d / (side / 2), 1e-14);
}

TEST_F(ContactLaws, ARegularTetrahedronHasAQuarterOfItsDistancePotentialInFdem) {
    const geometry::Polyhedron tetrahedron = geometry::regular_tetrahedron(1);
    const Block a = add(tetrahedron, {{0.1, 0.05, 0.5}, orientation()}), b = add(tetrahedron, {});
    const NormalContact distance = pairs.fast(a, b);
    ASSERT_TRUE(pairs.is_touching);
    pairs.options.potential = Potential::fdem;
    const NormalContact fdem = pairs.fast(a, b);
    expect_near(fdem.force, 0.25 * distance.force, 1e-15, "force");
    EXPECT_NEAR(fdem.energy, 0.25 * distance.energy, 1e-15);
    EXPECT_NEAR(fdem.stiffness, 0.25 * distance.stiffness, 1e-13);
}

TEST_F(ContactLaws, ARememberedDirectionChangesNoBit) {
    const Block a = hull(8), b = hull(9);
    SeparatingCache kept;
    int apart = 0, touching = 0;
    for (int i = 0; i < 4000; ++i) {
        const double t = 0.002 * i;
        const Pose pose = turned(moved(b.pose, {0.9 * std::cos(t), 0.5 * std::sin(1.7 * t), 0.6 * std::sin(t)}),
                                 {t, 0.3 * t, 0.1 * t});
        const auto look = [&](SeparatingCache& cache, NormalContact& contact) {
            return find_contact(pairs.shapes.view(a.shape), to_frame(pose), 1, pairs.shapes.view(b.shape),
                                to_frame(b.pose), 1, {}, cache, contact);
        };
        NormalContact with{}, without{};
        SeparatingCache none;
        const bool touches = look(kept, with);
        ASSERT_EQ(touches, look(none, without));
        ASSERT_EQ(std::memcmp(&with, &without, sizeof with), 0) << "step " << i;
        (touches ? touching : apart) += 1;
    }
    EXPECT_GT(apart, 500);
    EXPECT_GT(touching, 500);
}

TEST_F(ContactLaws, DegenerateAlignmentsAgreeWithTheOracleAndStayFinite) {
    const geometry::Polyhedron cube = geometry::cube(1), slab = geometry::box({2, 1, 0.5});
    const Quat eighth = from_rotation_vector({0, 0, std::numbers::pi / 4});
    const Quat quarter = from_rotation_vector({0, std::numbers::pi / 2, 0});
    const std::vector<Pose> poses{
        {{0, 0, 0.99}, {}},       {{0.5, 0, 0.99}, {}},      {{0.5, 0.5, 0.99}, {}},   {{0.99, 0.99, 0}, {}},
        {{0.99, 0.99, 0.99}, {}}, {{0, 0, 0}, {}},           {{0, 0, 0}, eighth},      {{0, 0, 0.9}, eighth},
        {{0.5, 0, 0}, eighth},    {{0.25, 0.25, 0}, eighth}, {{0, 0, 0.8}, quarter},   {{0.5, 0, 0.5}, {}},
        {{0, 0.5, 0.3}, quarter}, {{1.0, 0, 0.7}, {}},       {{0.3, 0, 0.5}, quarter}, {{1, 0, 0}, {}}};
    const std::vector<geometry::Polyhedron> shapes{cube, slab, geometry::cube(0.25), geometry::regular_tetrahedron(1),
                                                   geometry::octahedron(1)};
    for (std::size_t s = 0; s < shapes.size() * shapes.size(); ++s) {
        const Block b = add(shapes[s % shapes.size()], {});
        Block a = add(shapes[s / shapes.size()], {});
        for (const Pose& pose : poses) {
            a.pose = pose;
            const NormalContact plain = pairs.plain(a, b);
            const bool plain_touches = pairs.is_touching;
            const NormalContact fast = pairs.fast(a, b);
            ASSERT_EQ(pairs.is_touching, plain_touches) << pose.position.x << ' ' << pose.position.z << " shapes " << s;
            EXPECT_LE(norm(fast.force - plain.force), 1e-12);
            EXPECT_LE(norm(moment_about(fast, {}) - moment_about(plain, {})), 1e-12);
            EXPECT_NEAR(fast.energy, plain.energy, 1e-12)
                << "shapes " << s << " at " << pose.position.x << ' ' << pose.position.y << ' ' << pose.position.z;
            EXPECT_NEAR(fast.area, plain.area, 1e-12);
            EXPECT_TRUE(is_finite(fast.point) && is_finite(fast.moment) && std::isfinite(fast.stiffness));
        }
    }
}

TEST_F(ContactLaws, ABlockInsideAnotherFeelsTheFieldOfBoth) {
    // E = int over the small cube of (phi_A + phi_B): phi_A integrates to V/4 in a cube of its own; of phi_B, linear
    // below one face here, the mean is the depth of the centre over r.
    const Block small = add(geometry::cube(0.1), {{0.3, 0.02, 0.01}, {}}), large = add(geometry::cube(1), {});
    const NormalContact contact = pairs.fast(small, large);
    EXPECT_NEAR(contact.energy, 1e-3 * (0.25 + 0.2 / 0.5), 1e-15);
    expect_near(contact.force, {1e-3 / 0.5, 0, 0}, 1e-15, "force");
    const NormalContact swapped = pairs.fast(large, small);
    EXPECT_NEAR(swapped.energy, contact.energy, 1e-15);
}

TEST_F(ContactLaws, TwoHundredCornersAreNoLimit) {
    const Block a = hull(200), b = hull(200);
    Block near = a;
    near.pose.position = b.pose.position + Vec3{0.5, 0.4, 0.3};
    const NormalContact contact = pairs.fast(near, b);
    ASSERT_TRUE(pairs.is_touching);
    const auto energy = [&](double x) {
        return pairs.fast({a.shape, moved(near.pose, {x, 0, 0}), a.stiffness}, b).energy;
    };
    const double h = 1e-5;
    EXPECT_NEAR(contact.force.x, -(energy(h) - energy(-h)) / (2 * h), 1e-8);
}

}  // namespace
}  // namespace riprap::contact
