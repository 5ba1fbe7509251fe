// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "riprap/contact/law/joint_laws.hpp"
#include "riprap/contact/law/penalty.hpp"

namespace riprap::contact {
namespace {

TEST(JointLaws, CoulombBearsFrictionOfThePushAndCohesionButNeverLessThanNothing) {
    EXPECT_DOUBLE_EQ(shear_strength({}, {.push = 200, .friction = 0.5, .cohesion = 30}), 130);
    EXPECT_DOUBLE_EQ(shear_strength({}, {.push = 200, .friction = 0.5}), 100);
    EXPECT_DOUBLE_EQ(shear_strength({}, {.push = -20, .friction = 0.5, .cohesion = 30}), 20);
    EXPECT_EQ(shear_strength({}, {.push = -200, .friction = 0.5, .cohesion = 30}), 0);
}

TEST(JointLaws, APointOfExplicitDdaSlidesWithTheStrengthOfTheLawAndABrokenBondKeepsFriction) {
    const PenaltySprings springs{.normal_stiffness = 1e6, .shear_stiffness = 1e6, .friction = 0.5, .cohesion = 300};
    PenaltyMotion motion{{0, 0, 1}, -1e-3, {1, 0, 0}, 2e-3, {}, true};  // pushed with 1000 N, slid by 2 mm
    EXPECT_NEAR(norm(penalty({}, springs, motion).force - Vec3{-500, 0, -1000}), 0, 1e-9) << "the bond has broken";
    motion.is_intact = false;
    EXPECT_NEAR(norm(penalty({}, springs, motion).force - Vec3{-500, 0, -1000}), 0, 1e-9);
    motion.is_intact = true;
    PenaltySprings tough = springs;
    tough.bond_slip = 1;
    EXPECT_NEAR(norm(penalty({}, tough, motion).force - Vec3{-800, 0, -1000}), 0, 1e-9);
}

}  // namespace
}  // namespace riprap::contact
