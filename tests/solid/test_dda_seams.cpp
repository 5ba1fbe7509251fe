// SPDX-License-Identifier: Apache-2.0
// Blocks that slide over seams: the side of the next block is hidden by the one stood on.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "riprap/solid/affine/seams.hpp"
#include "riprap/solid/planar_dda/seams.hpp"
#include "sliding_blocks.hpp"

namespace riprap::solid {
namespace {

class DdaSeams : public ::testing::TestWithParam<Dda> {};
INSTANTIATE_TEST_SUITE_P(Methods, DdaSeams, ::testing::Values(Dda::planar, Dda::implicit, Dda::explicit_), name_of);

class ImplicitSeams : public ::testing::TestWithParam<Dda> {};
INSTANTIATE_TEST_SUITE_P(Methods, ImplicitSeams, ::testing::Values(Dda::planar, Dda::implicit), name_of);

constexpr double speed = 3;

/// Two slabs with a joint between them, which leans by `lean` a metre, and a block without friction that comes from the
/// left. The slab on the right lies higher by `step`.
Scene two_slabs(double gap, double step, double lean = 0) {
    Scene scene;
    scene.pieces.push_back({{{-3, -0.5}, {-0.5 * gap - 0.5 * lean, -0.5}, {-0.5 * gap, 0}, {-3, 0}}});
    scene.pieces.push_back({{{0.5 * gap - 0.5 * lean, -0.5 + step}, {3, -0.5 + step}, {3, step}, {0.5 * gap, step}}});
    scene.pieces.push_back({box(-0.85, 0, 0.7, 0.3), false, speed});
    return scene;
}
/// Breadth of that block, as the method measures it [m].
double breadth_of_block(Dda method) { return method == Dda::planar ? 2 * 0.21 / 2.0 : 0.3; }

TEST_P(DdaSeams, ABlockSlidesOverASeamAsIfThereWereNone) {
    for (const auto& [gap, step] : {std::pair{0.0, 0.0}, {2e-5, 0.0}, {-2e-5, 2e-5}, {1e-3, -2e-5}, {0.0, -1e-3}}) {
        EXPECT_NEAR(slide(GetParam(), two_slabs(gap, step)).velocity.x, speed, 1e-3 * speed) << gap << ' ' << step;
    }
}

TEST_P(DdaSeams, TheAngleOfTheJointDoesNotMatter) {
    for (const double angle : {20.0, 45.0, 75.0, 110.0, 150.0}) {
        const double lean = 1 / std::tan(angle * std::numbers::pi / 180);
        EXPECT_NEAR(slide(GetParam(), two_slabs(0, 0, lean)).velocity.x, speed, 1e-3 * speed) << angle;
    }
}

TEST_P(DdaSeams, NorDoTheStepAndTheStiffness) {
    for (const auto& [stiffness, dt] : {std::pair{1e8, 1e-4}, {1e8, 4e-3}, {1e7, 1e-3}, {1e9, 1e-3}}) {
        Scene scene = two_slabs(0, 0);
        scene.stiffness = stiffness;
        scene.dt = dt;
        EXPECT_NEAR(slide(GetParam(), scene).velocity.x, speed, 1e-3 * speed) << stiffness << ' ' << dt;
    }
}

TEST_P(ImplicitSeams, AStepOfAHundredthOfTheBlockStopsIt) {
    for (const double step : {1e-3, 5e-3}) {
        EXPECT_LT(slide(GetParam(), two_slabs(0, step)).velocity.x, 0.6 * speed) << step;
    }
}

TEST_P(ImplicitSeams, AStepIsHitFromItsShareOfTheBlockOn) {
    Scene low = two_slabs(0, 3e-4 * breadth_of_block(GetParam()));
    Scene high = two_slabs(0, 8e-4 * breadth_of_block(GetParam()));
    low.stiffness = high.stiffness = 1e10;  // an overlap far below the step
    EXPECT_GT(slide(GetParam(), low).velocity.x, 0.99 * speed);
    EXPECT_LT(slide(GetParam(), high).velocity.x, 0.9 * speed);
    EXPECT_EQ(planar_dda::step_share, affine::step_share);
}

TEST(PlanarSeams, ASoftBlockIsHitFromTwiceItsOverlapOnUpToAShareOfTheBlock) {
    const double breadth = breadth_of_block(Dda::planar);
    const auto speed_after = [](double overlap, double step) {
        Scene scene = two_slabs(0, step);
        scene.stiffness = 0.21 * 2500 * 9.81 / overlap / 2;            // of two corners
        scene.pieces.back().corners = box(-0.85, -overlap, 0.7, 0.3);  // at rest on its springs
        scene.dt = 1e-4;                                               // a way below the overlap
        return slide(Dda::planar, scene).velocity.x;
    };
    EXPECT_GT(speed_after(2e-3 * breadth, 1.4 * 2e-3 * breadth), 0.97 * speed);
    EXPECT_LT(speed_after(2e-3 * breadth, 3.2 * 2e-3 * breadth), 0.9 * speed);
    const double most = 1e-2 * breadth;
    EXPECT_GT(speed_after(most, 0.7 * most), 0.95 * speed);
    EXPECT_LT(speed_after(most, 1.5 * most), 0.9 * speed);
}

/// Tells whether a block that stands on one slab meets the top of the next or its side, 1 mm before it comes there.
bool meets_the_top(double overlap, double step, double gap = 0) {
    affine::BlockScene system;
    affine::BlockState blocks;
    set_material(system, {2500, 1e9, 0.25}, {1e8, 1e8});
    for (const Piece& piece : two_slabs(gap, step).pieces) {
        add_polyhedron(system, blocks, geometry::planar_prism(piece.corners).value(), {.is_fixed = piece.is_fixed});
    }
    blocks.position.back() += Vec3{0.149 - 0.5 * gap, -overlap, 0};
    affine::PlacedBlocks placed;
    place_blocks(system, blocks, placed);
    affine::ContactFinder finder;
    bool is_side = false;
    for (const affine::BlockContact& contact : finder.find(system, blocks, placed, {}, 0.02)) {
        is_side = is_side || (contact.a == 1 && std::abs(contact.normal.x) > 0.5);
    }
    return !is_side;
}

TEST(AffineSeams, ThePlaneTurnsToTheTopUpToAStepAndAJointOfTheBlock) {
    // As numbers: the shares themselves are what is tested.
    const double breadth = breadth_of_block(Dda::implicit), stiff = 1e-7;
    EXPECT_TRUE(meets_the_top(stiff, 4e-4 * breadth));
    EXPECT_FALSE(meets_the_top(stiff, 6e-4 * breadth));
    const double soft = 2e-3 * breadth;
    EXPECT_TRUE(meets_the_top(soft, 1.8 * soft));
    EXPECT_FALSE(meets_the_top(soft, 2.2 * soft));
    const double most = 1e-2 * breadth;
    EXPECT_TRUE(meets_the_top(most, 0.9 * most));
    EXPECT_FALSE(meets_the_top(most, 1.1 * most));
    EXPECT_TRUE(meets_the_top(1e-5, 0, 2.2e-2 * breadth));
    EXPECT_TRUE(meets_the_top(1e-5, 0, 2.8e-2 * breadth));  // which the block bridges
    EXPECT_FALSE(meets_the_top(1e-5, 6e-4 * breadth, 2.8e-2 * breadth));
    EXPECT_EQ(planar_dda::step_share, affine::step_share);
    EXPECT_EQ(planar_dda::soft_step_share, affine::soft_step_share);
    EXPECT_EQ(planar_dda::joint_share, affine::joint_share);
}

/// Two slabs with a joint, turned by an angle, and a block that comes over the first of them.
Scene turned_joint(double gap, double length, double velocity, double angle = 0) {
    Scene scene;
    scene.pieces.push_back({box(-3, -0.5, 3, 0.5)});
    scene.pieces.push_back({box(gap, -0.5, 3, 0.5)});
    scene.pieces.push_back({box(-length - 0.15, 0, length, 0.3), false, velocity});
    const double c = std::cos(angle), s = std::sin(angle);
    for (Piece& piece : scene.pieces) {
        for (geometry::Point2& p : piece.corners) {
            p = {c * p[0] - s * p[1], s * p[0] + c * p[1]};
        }
    }
    return scene;
}

TEST_P(DdaSeams, ABlockBridgesAJointNarrowerThanHalfOfItself) {
    for (const auto& [gap, length] : {std::pair{2e-3, 0.7},
                                      {5e-3, 0.7},
                                      {1e-2, 0.7},
                                      {2e-2, 0.7},
                                      {5e-2, 0.7},
                                      {1.5e-2, 0.5},
                                      {3.5e-2, 0.5},
                                      {0.15, 0.5}}) {
        EXPECT_NEAR(slide(GetParam(), turned_joint(gap, length, speed)).velocity.x, speed, 1e-2 * speed)
            << gap << ' ' << length;
    }
}

TEST_P(DdaSeams, AlsoWithOtherStepsAndStiffnesses) {
    for (const auto& [stiffness, dt] : {std::pair{1e8, 2.5e-4}, {1e8, 4e-3}, {2.5e7, 1e-3}, {4e8, 1e-3}, {1e9, 1e-3}}) {
        Scene scene = turned_joint(1.5e-2, 0.5, speed);
        scene.stiffness = stiffness;
        scene.dt = dt;
        EXPECT_NEAR(slide(GetParam(), scene).velocity.x, speed, 1e-2 * speed) << stiffness << ' ' << dt;
    }
}

TEST_P(DdaSeams, AFrontThatHasTippedIntoAJointIsCaught) {
    // The centre is over the joint for 0.1 s before the front comes to the far side, and sinks by centimetres.
    Scene scene = turned_joint(0.45, 0.7, 1);
    scene.end = 0.8;
    EXPECT_LT(slide(GetParam(), scene).velocity.x, 0.7);
}

TEST_P(ImplicitSeams, ABlockOverAJointIsHitByAStepOnItsFarSide) {
    for (const double gap : {1e-2, 3.5e-2}) {
        Scene scene = turned_joint(gap, 0.5, speed);
        for (geometry::Point2& p : scene.pieces[1].corners) {
            p[1] += 3e-3;
        }
        EXPECT_LT(slide(GetParam(), scene).velocity.x, 0.6 * speed) << gap;
    }
}

TEST_P(DdaSeams, ABlockBridgesAJointInASlope) {
    const double angle = -0.35;
    Scene scene = turned_joint(2e-2, 0.7, 0, angle);
    scene.end = 0.5;
    const Ending end = slide(GetParam(), scene);
    const double gained = 9.81 * std::sin(-angle) * scene.end;
    EXPECT_NEAR(end.velocity.x, gained * std::cos(angle), 0.02 * gained);
    EXPECT_NEAR(end.velocity.y, gained * std::sin(angle), 0.02 * gained);
}

TEST_P(DdaSeams, ABlockBridgesJointsBetweenFreeBlocks) {
    Scene scene;
    scene.pieces.push_back({box(-3, -1, 6, 0.5)});
    for (int i = 0; i < 4; ++i) {
        scene.pieces.push_back({box(-1.5 + 0.62 * i, -0.5 - 1e-4, 0.6, 0.5), false});
    }
    scene.pieces.push_back({box(-1.4, -1e-5, 0.5, 0.3), false, speed});
    EXPECT_NEAR(slide(GetParam(), scene).velocity.x, speed, 1e-2 * speed);
}

/// A block on a slope of 30 degrees that is cut into blocks, or is one; as wide as the block, so that their edges lie
/// on each other and points of contact change their names.
Scene slope(Dda method, int blocks, double friction_angle) {
    constexpr double degree = std::numbers::pi / 180;
    Scene scene;
    for (int i = 0; i < blocks; ++i) {
        scene.pieces.push_back({box(-1.17 + 4.0 / blocks * i, -1, 4.0 / blocks, 1)});
    }
    scene.stiffness = 3e7;
    const double weight = 0.5 * 2500 * 9.81 * std::cos(30 * degree);
    const double overlap = weight / scene.stiffness / (method == Dda::planar ? 2 : 4);
    scene.pieces.push_back({box(-1, -overlap, 1, 0.5), false});  // at rest on its springs
    scene.gravity = {9.81 * std::sin(30 * degree), -9.81 * std::cos(30 * degree)};
    scene.friction = std::tan(friction_angle * degree);
    scene.end = 0.6;
    return scene;
}

TEST_P(DdaSeams, ABlockSlidesDownABenchCutByJointsAsCoulombSays) {
    const double friction = std::tan(20 * std::numbers::pi / 180);
    const double way = 0.5 * 9.81 * (0.5 - std::sqrt(0.75) * friction) * 0.36;
    for (const int blocks : {1, 4}) {  // the shear springs are stretched first, so it is a little ahead
        EXPECT_NEAR(slide(GetParam(), slope(GetParam(), blocks, 20)).moved.x, 1.02 * way, 0.03 * way) << blocks;
    }
}

TEST_P(DdaSeams, ABlockHoldsOnASlopeBelowItsAngleOfFriction) {
    for (const int blocks : {1, 4}) {
        EXPECT_LT(slide(GetParam(), slope(GetParam(), blocks, 35)).moved.x, 1e-2) << blocks;
    }
}

// The end of a slab farther back, from which the block hangs as over a joint, is not what carries its front.
TEST_P(DdaSeams, ABlockThatSpansSeveralFreeSlabsPassesTheirJoints) {
    for (const double width : {0.2, 0.25}) {
        Scene scene;
        scene.pieces.push_back({box(-3, -1, 6, 0.5)});
        for (const int first : {0, 1}) {  // every second slab comes before the others in the list of blocks
            for (int k = first; k < 12; k += 2) {
                scene.pieces.push_back({box(-0.85 + k * (width + 2e-5), -0.5, width, 0.5), false});
            }
        }
        scene.pieces.push_back({box(-0.85, 0, 0.7, 0.3), false, speed});
        EXPECT_NEAR(slide(GetParam(), scene).velocity.x, speed, 1e-2 * speed) << width;
    }
}

TEST_P(DdaSeams, ABlockSlidesOverFreeSlabsThatHaveDrifted) {
    Scene scene;
    scene.pieces.push_back({box(-1, -1.2, 4, 1)});
    scene.pieces.push_back({box(-1, -0.2, 0.5, 0.2)});
    const double drift[]{0, 2e-5, -1e-5, 1e-5, -2e-5};
    for (int i = 0; i < 5; ++i) {
        scene.pieces.push_back({box(-0.5 + 0.4 * i + drift[i], -0.2 + drift[4 - i], 0.4, 0.2), false});
    }
    scene.pieces.push_back({box(1.5 + 1e-4, -0.2, 0.5, 0.2)});
    scene.pieces.push_back({box(-0.45, 2e-5, 0.5, 0.25), false, speed});
    EXPECT_NEAR(slide(GetParam(), scene).velocity.x, speed, 1e-2 * speed);
}

TEST_P(DdaSeams, ACornerDrivenIntoTheValleyOfTwoBlocksHolds) {
    for (const double rise : {0.3, 1.0}) {
        Scene scene;
        scene.pieces.push_back({{{-2, -1}, {0, -1}, {0, 0}, {-2, 2 * rise}}});
        scene.pieces.push_back({{{0, -1}, {2, -1}, {2, 2 * rise}, {0, 0}}});
        scene.pieces.push_back({{{0, 1e-3}, {0.4, 1.001}, {-0.4, 1.001}}, false});
        scene.gravity = {0, -9.81};
        const Ending end = slide(GetParam(), scene);
        EXPECT_NEAR(end.moved.x, 0, 1e-4) << rise;
        EXPECT_GT(end.moved.y, -5e-3) << rise;
    }
}

}  // namespace
}  // namespace riprap::solid
