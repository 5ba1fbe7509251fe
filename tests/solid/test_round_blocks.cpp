// SPDX-License-Identifier: Apache-2.0
// Balls of both DDAs in space touch as spheres, not as the polyhedra that stand for them.
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/geometry/shapes.hpp"
#include "riprap/solid/affine/round_blocks.hpp"
#include "riprap/solid/explicit_dda/advance.hpp"
#include "riprap/solid/implicit_dda/advance.hpp"

namespace riprap::solid {
namespace {

struct World {
    affine::BlockSystem system;
    affine::BlockState blocks;

    explicit World(double friction = 0.5) { add_material(system, {2500, 1e10, 0.25}, {1e8, 4e7, false, friction}); }
    void add_ball(double radius, const Vec3& place, const Vec3& velocity = {}) {
        add_polyhedron(system, blocks, geometry::sphere(radius), {.velocity = velocity});
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
            EXPECT_EQ(implicit_dda::advance_in_pieces(system, {}, {}, 1e-3, {}, state, scratch, report).problem, "");
        }
        return state.blocks;
    }
};

TEST(RoundBlocks, TheSphereOfThePolyhedronHasItsVolume) {
    World world;
    world.add_ball(0.25, {});
    EXPECT_NEAR(affine::ball_radius(world.system.shape_of(0)), 0.25, 1e-9);
    world.add_floor({1, 1, 1}, {});
    EXPECT_EQ(affine::ball_radius(world.system.shape_of(1)), 0);
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

}  // namespace
}  // namespace riprap::solid
