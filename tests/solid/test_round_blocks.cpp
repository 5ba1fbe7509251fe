// SPDX-License-Identifier: Apache-2.0
// Balls of both DDAs in space touch as spheres, and discs of planar scenes as circles, not as the polyhedra that stand
// for them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "riprap/geometry/polyhedra/round_shapes.hpp"
#include "riprap/solid/affine/round_blocks.hpp"
#include "riprap/solid/explicit_dda/advance.hpp"
#include "riprap/solid/implicit_dda/advance.hpp"
#include "solid/block_scene.hpp"

namespace riprap::solid {
namespace {

struct World {
    affine::BlockScene system;
    affine::BlockState blocks;

    explicit World(double friction = 0.5) { set_material(system, {2500, 1e10, 0.25}, {1e8, 4e7, false, friction}); }
    void add_ball(double radius, const Vec3& place, const Vec3& velocity = {}) {
        add_polyhedron(system, blocks, geometry::sphere(radius), {.velocity = velocity});
        blocks.position.back() = place;
    }
    /// A disc as `shape = { sphere = radius }` makes it in a planar scene, turned by an angle [rad].
    void add_disc(double radius, const Vec3& place, const Vec3& velocity, double turned, bool is_planar = true) {
        constexpr int sides = 64;
        std::vector<geometry::Point2> corners;
        for (int k = 0; k < sides; ++k) {
            const double angle = 2 * std::numbers::pi * k / sides + turned;
            const double out = geometry::circumradius_of_equal_area(sides) * radius;
            corners.push_back({out * std::cos(angle), out * std::sin(angle)});
        }
        system.is_planar = is_planar;
        add_polyhedron(system, blocks, geometry::planar_prism(corners).value(), {.velocity = velocity});
        blocks.position.back() = place;
    }
    void add_floor(const Vec3& size, const Vec3& place) {
        add_box(system, blocks, size, {.position = place, .is_fixed = true});
    }
    std::vector<affine::BlockContact> contacts(double reach) const {
        affine::PlacedBlocks placed;
        place_blocks(system, blocks, placed);
        affine::ContactFinder finder;
        return finder.find(system, blocks, placed, {}, reach);
    }
    double kinetic_energy() const {
        double energy = 0;
        for (std::int32_t i = 0; i < system.size(); ++i) {
            const auto k = static_cast<std::size_t>(i);
            energy += 0.5 * 2500 * system.shape_of(i).volume * norm_squared(blocks.velocity[k]);
        }
        return energy;
    }
    affine::BlockState after(double end, bool is_explicit) const {
        if (is_explicit) {
            explicit_dda::State state{blocks, {}, 0};
            explicit_dda::Scratch scratch;
            explicit_dda::StepReport report;
            const double dt = 0.5 * explicit_dda::stable_step(system, blocks);
            for (double t = 0; t < end; t += dt) {
                EXPECT_EQ(explicit_dda::advance(system, {}, dt, {}, state, scratch, report).problem, "");
            }
            return state.blocks;
        }
        implicit_dda::State state{blocks, {}};
        implicit_dda::Scratch scratch;
        implicit_dda::StepReport report;
        for (int k = 0; k < static_cast<int>(end / 1e-3 + 0.5); ++k) {
            const Outcome outcome = in_pieces(1e-3, [&](double piece) {
                return implicit_dda::advance(system, {}, piece, {}, state, scratch, report);
            });
            EXPECT_EQ(outcome.problem, "");
        }
        return state.blocks;
    }
};

TEST(RoundBlocks, TheSphereOfThePolyhedronHasItsVolume) {
    World world;
    world.add_ball(0.25, {});
    EXPECT_NEAR(world.system.shape_of(0).round_radius, 0.25, 1e-9);
    world.add_floor({1, 1, 1}, {});
    EXPECT_EQ(world.system.shape_of(1).round_radius, 0);
}

TEST(RoundBlocks, ABallTouchesFacesEdgesCornersAndBallsWithItsSphere) {
    const double r = 0.25, gap = 1e-3;
    const double c = std::sqrt(0.5), d = std::sqrt(1.0 / 3);
    for (const Vec3& n : {Vec3{0, 1, 0}, Vec3{c, c, 0}, Vec3{d, d, d}}) {
        World world;
        world.add_floor({1, 1, 1}, {-0.5, -0.5, -0.5});  // its corner lies at the origin
        const Vec3 touched = n.y == 1 ? Vec3{-0.3, 0, -0.2} : n.z == 0 ? Vec3{0, 0, -0.2} : Vec3{};
        world.add_ball(r, touched + (r + gap) * n);
        const auto found = world.contacts(0.01);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_NEAR(found[0].gap, gap, 1e-9);
        EXPECT_LT(norm(found[0].normal - n), 1e-9);
        EXPECT_LT(norm(found[0].on_a - touched), 1e-9);
    }
    World world;
    world.add_ball(r, {});
    world.add_ball(0.5, {0.75 - gap, 0, 0});
    const auto found = world.contacts(0.01);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].gap, -gap, 1e-9);
    EXPECT_LT(norm(found[0].normal - Vec3{1, 0, 0}), 1e-9);
}

TEST(RoundBlocks, ABallInsideOfABlockIsPushedOutThroughTheNearestFace) {
    World world;
    world.add_floor({2, 2, 2}, {0, -1, 0});
    world.add_ball(0.25, {0.1, -0.05, 0});
    const auto found = world.contacts(0.01);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].gap, -0.3, 1e-9);
    EXPECT_LT(norm(found[0].normal - Vec3{0, 1, 0}), 1e-9);
}

TEST(RoundBlocks, ABallRollsDownASlopeWithoutSlipAndSlidesWhereFrictionIsTooLittle) {
    // a = 5/7 g sin where the friction is at least 2/7 tan of the angle, else g (sin - f cos).
    const double end = 0.3;
    for (const bool is_explicit : {false, true}) {
        for (const auto& [angle, radius, friction] :
             {std::tuple{0.35, 0.25, 0.5}, {0.6, 0.1, 0.5}, {0.35, 0.25, 0.05}, {0.1, 0.4, 0.9}}) {
            World world(friction);
            world.add_floor({8, 0.5, 4}, {1, -0.25, 0});
            world.add_ball(radius, {0, radius, 0});
            world.system.gravity = 9.81 * Vec3{std::sin(angle), -std::cos(angle), 0};
            const double moved = world.after(end, is_explicit).position.back().x;
            const double acceleration =
                std::max(5.0 / 7 * std::sin(angle), std::sin(angle) - friction * std::cos(angle));
            const double way = 0.5 * 9.81 * acceleration * end * end;
            EXPECT_NEAR(moved, way, 0.02 * way) << is_explicit << ' ' << angle << ' ' << friction;
        }
    }
}

TEST(RoundBlocks, ABallRestsOnAFloorAtItsRadiusAndIsNotThrownUp) {
    for (const bool is_explicit : {false, true}) {
        World world;
        world.add_floor({4, 0.5, 4}, {0, -0.25, 0});
        world.add_ball(0.25, {0, 0.25, 0});
        world.system.gravity = {0, -9.81, 0};
        const affine::BlockState end = world.after(0.2, is_explicit);
        EXPECT_NEAR(end.position.back().y, 0.25, 1e-4);
        EXPECT_LT(norm(end.velocity.back()), 0.03);
    }
}

TEST(RoundBlocks, ADiscTouchesWithItsCircleAtBothEndsOfItsThicknessHoweverItIsTurned) {
    const double r = 0.25, gap = 1e-3, c = std::sqrt(0.5);
    for (const double turned : {0.0, 0.02, 0.049}) {
        for (const Vec3& n : {Vec3{0, 1, 0}, Vec3{c, c, 0}, Vec3{0.6, 0.8, 0}}) {
            World world;
            world.add_floor({1, 1, 1}, {-0.5, -0.5, 0});  // its corner lies at the origin
            const Vec3 touched = n.y == 1 ? Vec3{-0.3, 0, 0} : Vec3{};
            world.add_disc(r, touched + (r + gap) * n, {}, turned);
            const auto found = world.contacts(0.01);
            ASSERT_EQ(found.size(), 2U);
            EXPECT_LT(found[0].feature, found[1].feature);
            for (const std::size_t k : {0U, 1U}) {
                EXPECT_NEAR(found[k].gap, gap, 1e-9);
                EXPECT_LT(norm(found[k].normal - n), 1e-9);
                EXPECT_LT(norm(found[k].on_a - touched - Vec3{0, 0, k == 0 ? -0.5 : 0.5}), 1e-9);
            }
        }
    }
}

TEST(RoundBlocks, APrismInSpaceIsNoDisc) {
    World world;
    world.add_floor({1, 1, 1}, {0, -0.5, 0});
    world.add_disc(0.25, {0, 0.2499, 0}, {}, 0, false);
    for (const affine::BlockContact& contact : world.contacts(1e-3)) {
        EXPECT_NE(contact.feature >> 60U, 4U);
    }
}

TEST(RoundBlocks, DiscsThatMeetHeadOnKeepTheirEnergyAndGetNoSidewaysSpeed) {
    // A corner of the prism ahead, an edge ahead, or anything between: 1/5 and 4/5 of the speed that came, of masses
    // 1:4.
    for (const double turned : {0.0, 0.02, 0.049}) {
        World world(0);
        world.add_disc(0.1, {-0.302, 0, 0}, {2, 0, 0}, turned);
        world.add_disc(0.2, {0, 0, 0}, {}, 0);
        const double energy = world.kinetic_energy();
        world.blocks = world.after(0.02, true);
        EXPECT_NEAR(world.blocks.velocity[0].x, -1.2, 0.01) << turned;
        EXPECT_NEAR(world.blocks.velocity[1].x, 0.8, 0.01) << turned;
        EXPECT_LT(std::abs(world.blocks.velocity[0].y), 1e-6) << turned;
        EXPECT_NEAR(world.kinetic_energy(), energy, 0.01 * energy) << turned;
        World slow(0);
        slow.add_disc(0.1, {-0.302, 0, 0}, {2, 0, 0}, turned);
        slow.add_disc(0.2, {0, 0, 0}, {}, 0);
        EXPECT_LT(std::abs(slow.after(0.02, false).velocity[0].y), 1e-6) << turned;
    }
}

}  // namespace
}  // namespace riprap::solid
