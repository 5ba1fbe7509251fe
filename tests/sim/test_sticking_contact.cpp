// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sim/small_scene.hpp"

namespace riprap::sim {
namespace {

/// A cube pressed on a floor by gravity, nudged sideways too weakly to slide.
struct NudgedCube {
    SmallScene scene;
    Scratch scratch;
    double dt;

    NudgedCube(double damping_ratio, double share_of_bound, double speed = 1e-4) {
        scene.model.gravity.value = {0, 0, -9.81};
        scene.rock().friction = 0.8;
        scene.rock().shear_ratio = 0.5;
        scene.rock().damping_ratio = damping_ratio;
        scene.mix();
        scene.add("floor", scene.add_shape(geometry::box({3, 3, 1})), {{0, 0, -0.5}, {}}, body::Drive::fixed);
        // Depth of rest: m g / K_n, K_n = 2 k_n A/r = 4e7 N/m.
        scene.add("cube", scene.add_shape(geometry::box({1, 1, 1})), {{0, 0, 0.5 - 2000 * 9.81 / 4e7}, {}},
                  body::Drive::free, {speed, 0, 0});
        initialise(scene.model, scene.state);
        dt = share_of_bound * time_step_bound(scene.model).limit;
    }
    /// Instead of the nudge: turns the cube about the vertical, with torsion as wanted.
    NudgedCube& twisted(double spin, bool has_torsion) {
        scene.rock().has_torsion = has_torsion;
        scene.mix();
        scene.state.bodies.velocity[1] = {};
        scene.state.bodies.angular_momentum[1] = {0, 0, spin * 2000 / 6.0};
        return *this;
    }
    StepReport run(double duration) {
        StepReport report;
        for (double t = 0; t < duration && report.status.ok(); t += dt) {
            report = advance(scene.model, scene.state, scratch, dt);
        }
        return report;
    }
};

// The motion left after two seconds is rocking about the contact point, which no dashpot at that point damps.
TEST(StickingContact, ANudgedCubeCalmsDownAndTheLedgerKnowsWhereItsEnergyWent) {
    NudgedCube cube(0.1, 0.15);
    const StepReport report = cube.run(2);
    ASSERT_TRUE(report.status.ok()) << report.status.text;
    const double put_in = 0.5 * 2000 * 1e-8;
    EXPECT_NEAR(report.ledger.friction, 0, 1e-6 * put_in);
    EXPECT_GT(report.ledger.contact_damping, 0.9 * put_in);
    EXPECT_LT(std::abs(report.ledger.residual), 0.01 * put_in);
}

// The torsional spring once had no dashpot: yaw that friction held rang on, grew where the load fed it, and let slopes
// of blocks slide a degree and a half below their friction angle.
TEST(StickingContact, ATwistedCubeCalmsDownAndTheLedgerKnowsWhereItsEnergyWent) {
    NudgedCube cube(0.1, 0.15);
    const double spin = 1e-3, put_in = 0.5 * 2000 / 6.0 * spin * spin;
    const StepReport report = cube.twisted(spin, true).run(2);
    ASSERT_TRUE(report.status.ok()) << report.status.text;
    EXPECT_LT(std::abs(angular_velocity(cube.scene.model.bodies, cube.scene.state.bodies, BodyId{1}).z), 1e-8);
    EXPECT_NEAR(report.ledger.contact_damping, put_in, 0.02 * put_in);
    EXPECT_LT(std::abs(report.ledger.residual), 0.01 * put_in);
}

TEST(StickingContact, WithoutDashpotsItRingsOn) {
    NudgedCube cube(0, 0.15);
    const StepReport report = cube.run(2);
    EXPECT_GT(report.ledger.kinetic + report.ledger.shear, 0.2 * 0.5 * 2000 * 1e-8);
    EXPECT_EQ(report.ledger.contact_damping, 0);
}

TEST(StickingContact, IsStableUpToTheBoundAtAnyDamping) {
    for (const double damping_ratio : {0.1, 0.5, 1.0}) {
        NudgedCube cube(damping_ratio, 0.95);
        const StepReport report = cube.run(2);
        ASSERT_TRUE(report.status.ok()) << report.status.text;
        EXPECT_LT(norm(cube.scene.state.bodies.velocity[1]), 1e-4) << "xi = " << damping_ratio;
    }
}

}  // namespace
}  // namespace riprap::sim
