// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/solid/affine/restitution.hpp"
#include "riprap/solid/explicit_dda/advance.hpp"
#include "solid/block_scene.hpp"

namespace riprap::solid {
namespace {

/// Speed after a mass on a spring with a share z of critical damping has met a wall at 1 m/s and does not pull.
double bounced(double z) {
    double x = 0, v = 1;
    const double dt = 1e-5;
    while (true) {
        const double force = x + 2 * z * v;  // mass and spring of 1
        if (force < 0 || x < 0) {
            return -v;
        }
        v -= dt * force;
        x += dt * v;
    }
}

TEST(Restitution, FollowsFromTheMotionOfADampedSpringThatDoesNotPull) {
    for (const double z : {0.05, 0.3, 0.6, 0.8, 1.0, 2.0}) {
        EXPECT_NEAR(affine::restitution_of(z), bounced(z), 2e-4) << z;
    }
}

TEST(Restitution, AndTheDampingRatioFromIt) {
    for (const double e : {1.0, 0.9, 0.5, 0.3, 0.1, 0.01}) {
        EXPECT_NEAR(affine::restitution_of(affine::damping_ratio_of(e)), e, 1e-9) << e;
    }
}

TEST(Restitution, OfAPairComesBeforeItsDampingRatio) {
    material::MaterialSet set;
    set.materials.resize(2);
    for (material::Material& m : set.materials) {
        m.damping_ratio = 0.1;
    }
    mix_pairs(set, material::Mixing::mean, material::Mixing::mean);
    const MaterialId a{0}, b{1};
    set.materials[0].restitution = 0.4;
    EXPECT_EQ(affine::damping_ratio_of(set, a, b), 0.1);  // one of them says nothing
    set.materials[1].restitution = 0.6;
    EXPECT_NEAR(affine::restitution_of(affine::damping_ratio_of(set, a, b)), 0.5, 1e-9);
    set.pairs[1].restitution = 1;
    EXPECT_GT(affine::damping_ratio_of(set, a, b), 0);
    EXPECT_LT(affine::damping_ratio_of(set, a, b), 1e-12);
}

/// Speed with which a cube of 0.4 m leaves a floor that it meets at 1 m/s, flat or with an edge, in explicit DDA.
double leaves(double e, bool is_flat) {
    affine::BlockScene system;
    affine::BlockState blocks;
    set_material(system, {2500, 1e11, 0.25}, {1e8, 4e7, false, 0, 0, 0, affine::damping_ratio_of(e)});
    add_box(system, blocks, {4, 1, 4}, {.position = {0, -0.5, 0}, .is_fixed = true});
    const double c = std::sqrt(0.5);
    const Mat3 turn = is_flat ? Mat3::identity() : Mat3{{{c, -c, 0}, {c, c, 0}, {0, 0, 1}}};
    add_box(system, blocks, {0.4, 0.4, 0.4},
            {.position = {0, is_flat ? 0.201 : 0.4 * c + 1e-3, 0}, .deformation = turn, .velocity = {0, -1, 0}});
    explicit_dda::State state{blocks, {}, 0};
    explicit_dda::Scratch scratch;
    explicit_dda::StepReport report;
    const double dt = 0.5 * explicit_dda::stable_step(system, blocks);
    for (double t = 0; t < 0.02; t += dt) {
        EXPECT_EQ(explicit_dda::advance(system, {}, dt, {}, state, scratch, report).problem, "");
    }
    return state.blocks.velocity.back().y;
}

TEST(Restitution, CornersOfAFaceAndOfAnEdgeShareTheMassInExplicitDda) {
    for (const double e : {0.3, 0.5, 0.8}) {
        EXPECT_NEAR(leaves(e, true), e, 0.03) << e;
        EXPECT_NEAR(leaves(e, false), e, 0.03) << e;
    }
}

}  // namespace
}  // namespace riprap::solid
