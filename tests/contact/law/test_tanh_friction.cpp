// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/law/tanh_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace riprap::contact {
namespace {

/// A lies above B and slides along x at `speed`.
struct Slide {
    NormalContact normal{};
    material::PairProperties pair{.shear_ratio = 0.5, .friction = 0.4};
    ContactKinematics motion{};
    ShearState after{};
    ContactRow row{};

    explicit Slide(double speed) {
        normal.force = {0, 0, 1000};
        normal.stiffness = 1e6;
        motion.relative_velocity = {speed, 0, 0};
        motion.sliding_time = 1e-3;
        motion.effective_mass = 4;
        motion.tangential_mass = 3;
    }
    LinearContact respond(double friction_speed) {
        return TanhFriction{friction_speed}.respond(normal, pair, motion, nullptr, after, row);
    }
};

TEST(TanhFriction, of_polyhedra_grows_with_speed_to_coulombs_limit) {
    for (const double speed : {0.3, 0.5, 2.0}) {
        Slide slide(speed);
        slide.respond(0.5);
        EXPECT_NEAR(slide.row.force.x, -400 * std::tanh(speed / 0.5), 1e-9) << speed;
        EXPECT_NEAR(slide.row.force.z, 1000, 1e-9);
    }
}

TEST(TanhFriction, of_polyhedra_stores_nothing_and_is_booked_as_a_dashpot_of_its_power) {
    Slide slide(0.3);
    slide.respond(0.5);
    EXPECT_EQ(slide.after.shear_energy, 0);
    EXPECT_EQ(slide.after.shear_force, Vec3{});
    EXPECT_EQ(slide.row.friction_loss, 0);
    EXPECT_NEAR(slide.row.dashpot_power, -400 * std::tanh(0.6) * 0.3, 1e-4);
}

TEST(TanhFriction, of_polyhedra_takes_at_most_half_of_the_sliding_speed_in_a_step) {
    Slide slide(1e-4);
    const LinearContact linear = slide.respond(1e-6);  // the tanh is 1: 400 N, far above
    EXPECT_NEAR(slide.row.force.x * 1e-3 / 3, -0.5e-4, 1e-15);
    EXPECT_NEAR(linear.shear_damping, 3 / (2 * 1e-3), 1e-9);
    EXPECT_EQ(linear.shear_stiffness, 0);
}

}  // namespace
}  // namespace riprap::contact
