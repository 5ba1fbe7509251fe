// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/law/penalty.hpp"

#include <gtest/gtest.h>

namespace riprap::contact {
namespace {

const PenaltySprings springs{.normal_stiffness = 100, .shear_stiffness = 50, .friction = 0.5};

PenaltyMotion pressed(double overlap, const Vec3& slip) { return {{0, 0, 1}, -overlap, {}, 0.1, slip, false}; }

TEST(Penalty, the_push_is_the_spring_and_acts_against_the_normal_on_a) {
    const PenaltyAnswer answer = penalty({}, springs, pressed(0.2, {}));
    EXPECT_DOUBLE_EQ(answer.force.z, -20);
    EXPECT_DOUBLE_EQ(answer.energy, 0.5 * 100 * 0.04);
}

TEST(Penalty, nothing_pulls_across_an_open_contact) { EXPECT_TRUE(penalty({}, springs, pressed(-0.1, {})).is_open); }

TEST(Penalty, an_intact_contact_pulls_up_to_its_tensile_strength) {
    PenaltySprings bonded = springs;
    bonded.tension = 15;
    PenaltyMotion motion = pressed(-0.1, {});
    motion.is_intact = true;
    EXPECT_DOUBLE_EQ(penalty({}, bonded, motion).force.z, 10);
    motion.gap = 0.2;
    EXPECT_TRUE(penalty({}, bonded, motion).is_open);
}

TEST(Penalty, slip_within_the_limit_is_elastic) {
    PenaltyMotion motion = pressed(0.2, {0.1, 0, 0});
    motion.velocity = {0.2, 0, 0};
    const PenaltyAnswer answer = penalty({}, springs, motion);
    EXPECT_FALSE(answer.is_sliding);
    EXPECT_DOUBLE_EQ(answer.slip.x, 0.12);
    EXPECT_DOUBLE_EQ(answer.force.x, -6);
    EXPECT_DOUBLE_EQ(answer.friction_loss, 0);
}

TEST(Penalty, sliding_holds_the_limit_and_takes_the_slip_lost_times_the_mean_force) {
    PenaltyMotion motion = pressed(0.2, {0.1, 0, 0});
    motion.velocity = {3, 0, 0};
    const PenaltyAnswer answer = penalty({}, springs, motion);
    EXPECT_TRUE(answer.is_sliding);
    EXPECT_DOUBLE_EQ(answer.force.x, -10);
    EXPECT_DOUBLE_EQ(answer.slip.x, 0.2);
    EXPECT_DOUBLE_EQ(answer.friction_loss, 0.5 * (5 + 10) * 0.2);  // the spring pulled with 5 N before
}

TEST(Penalty, a_bond_keeps_its_cohesion_until_it_has_slid_by_its_length) {
    PenaltySprings bonded = springs;
    bonded.cohesion = 5;
    bonded.bond_slip = 0.1;
    PenaltyMotion motion = pressed(0.2, {0.35, 0, 0});  // 17.5 of 15 N: 0.05 of it plastic
    motion.is_intact = true;
    const PenaltyAnswer yields = penalty({}, bonded, motion);
    EXPECT_TRUE(yields.is_sliding);
    EXPECT_TRUE(yields.is_intact);
    EXPECT_DOUBLE_EQ(yields.force.x, -15);
    EXPECT_NEAR(yields.plastic_slip, 0.05, 1e-15);
    EXPECT_NEAR(yields.friction_loss, 0.5 * (17.5 + 15) * 0.05, 1e-14);
    motion.plastic_slip = 0.06;
    const PenaltyAnswer broken = penalty({}, bonded, motion);
    EXPECT_FALSE(broken.is_intact);
    EXPECT_DOUBLE_EQ(broken.force.x, -10);
}

TEST(Penalty, cohesion_holds_until_the_first_slip_which_takes_the_energy_of_the_bond) {
    PenaltySprings bonded = springs;
    bonded.cohesion = 5;
    PenaltyMotion motion = pressed(0.2, {0.25, 0, 0});
    motion.is_intact = true;
    EXPECT_FALSE(penalty({}, bonded, motion).is_sliding);  // 12.5 of 15 N
    motion.slip = {0.35, 0, 0};
    const PenaltyAnswer broken = penalty({}, bonded, motion);
    EXPECT_TRUE(broken.is_sliding);
    EXPECT_FALSE(broken.is_intact);
    EXPECT_DOUBLE_EQ(broken.force.x, -10);
    EXPECT_DOUBLE_EQ(broken.slip.x, 0.2);
    EXPECT_DOUBLE_EQ(broken.friction_loss, 0.5 * 50 * (0.35 * 0.35 - 0.2 * 0.2));
    bonded.tension = 5;
    motion.gap = 0.01;
    EXPECT_TRUE(penalty({}, bonded, motion).is_open);
}

TEST(Penalty, a_dashpot_never_pulls) {
    PenaltySprings damped = springs;
    damped.normal_damping = 1000;
    PenaltyMotion motion = pressed(0.01, {});
    motion.velocity = {0, 0, -1};
    EXPECT_DOUBLE_EQ(penalty({}, damped, motion).force.z, 0);
}

}  // namespace
}  // namespace riprap::contact
