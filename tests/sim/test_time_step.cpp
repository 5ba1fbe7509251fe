// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sim/small_scene.hpp"

namespace riprap::sim {
namespace {

using geometry::box;

/// Largest energy residual over the energy put in, for a cube that is let fall a little onto a floor.
double residual_of_a_landing(double damping_ratio, double share_of_bound) {
    SmallScene scene;
    scene.model.gravity.value = {0, 0, -9.81};
    scene.rock().damping_ratio = damping_ratio;
    scene.mix();
    scene.add("floor", scene.add_shape(box({3, 3, 1})), {{0, 0, -0.5}, {}}, body::Drive::fixed);
    scene.add("cube", scene.add_shape(box({1, 1, 1})), {{0, 0, 0.51}, {}});
    initialise(scene.model, scene.state);
    Scratch scratch;
    const double dt = share_of_bound * time_step_bound(scene.model).limit;
    double worst = 0;
    for (double t = 0; t < 0.5; t += dt) {
        const StepReport report = advance(scene.model, scene.state, scratch, dt);
        worst = std::max(worst, report.status.ok() ? std::abs(report.ledger.residual) : 1e300);
    }
    return worst / (2000 * 9.81 * 0.01);
}

// A maintainer's find: the bound once ignored dashpots, and a critically damped cube at 0.9 of it gained four times
// the energy it had fallen with.
TEST(TimeStepBound, ACriticallyDampedLandingIsStableUpToTheBound) {
    for (const double damping_ratio : {0.0, 0.3, 1.0}) {
        EXPECT_LT(residual_of_a_landing(damping_ratio, 0.95), 0.6) << "xi = " << damping_ratio;
        EXPECT_LT(residual_of_a_landing(damping_ratio, 0.15), 0.03) << "xi = " << damping_ratio;
    }
}

TEST(TimeStepBound, ALightSoftBodyIsBoundByTheStiffestNeighbour) {
    const auto limit_beside = [](double stiff) {
        SmallScene scene;
        scene.model.materials.materials = {{.name = "wood", .density = 300, .normal_stiffness = 1e7},
                                           {.name = "steel", .density = 7850, .normal_stiffness = stiff}};
        scene.mix();
        const ShapeId cube = scene.add_shape(box({1, 1, 1}));
        scene.add("wood", cube, {});
        const BodyId steel = scene.add("steel", cube, {{2, 0, 0}, {}});
        scene.model.bodies.material[static_cast<std::size_t>(steel.value)] = MaterialId{1};
        scene.model.bodies.mass[static_cast<std::size_t>(steel.value)] = 7850;
        return time_step_bound(scene.model).limit;
    };
    // Wood between two steel cubes: omega^2 = 2 A (k_w + k_s)/r (1/m_w + 1/sqrt(m_w m_s)).
    const double omega_squared = 2 * (1e7 + 1e10) / 0.5 * (1 / 300.0 + 1 / std::sqrt(300.0 * 7850.0));
    EXPECT_LE(limit_beside(1e10), 2 / std::sqrt(omega_squared) * (1 + 1e-12));
}

TEST(Kick, LocalDampingTakesItsShareOfTheForceThatSpeedsABodyUp) {
    SmallScene scene;
    scene.model.gravity.value = {0, 0, -10};
    scene.model.dem()->local_damping = 0.3;
    scene.add("stone", scene.add_shape(box({1, 1, 1})), {}, body::Drive::free, {0, 0, -1});
    const StepReport report = scene.run(100, 1e-3);
    EXPECT_NEAR(scene.state.bodies.velocity[0].z, -1 - 0.7 * 10 * 0.1, 1e-12);
    EXPECT_LT(std::abs(report.ledger.residual), 1e-9 * report.ledger.turnover);
}

TEST(Kick, MassDampingSlowsAFreeBodyExponentially) {
    SmallScene scene;
    scene.model.dem()->mass_damping = 2;
    scene.add("stone", scene.add_shape(box({1, 1, 1})), {}, body::Drive::free, {3, 0, 0}, {0, 0, 1});
    scene.run(1000, 1e-3);
    EXPECT_NEAR(scene.state.bodies.velocity[0].x, 3 * std::exp(-2.0), 2e-3);
    EXPECT_NEAR(angular_velocity(scene.model.bodies, scene.state.bodies, BodyId{0}).z, std::exp(-2.0), 1e-3);
}

TEST(Kick, LoadsFromOutsideWorkOnABodyAndAreBooked) {
    SmallScene scene;
    scene.add("stone", scene.add_shape(box({1, 1, 1})), {});
    initialise(scene.model, scene.state);
    Scratch scratch;
    const std::vector<Vec3> force{{500, 0, 0}}, torque{{0, 0, 100}};
    StepReport report;
    for (int i = 0; i < 1000; ++i) {
        report = advance(scene.model, scene.state, scratch, 1e-3, Measure::energy, {force, torque});
    }
    EXPECT_NEAR(scene.state.bodies.velocity[0].x, 500.0 / 2000, 1e-12);
    // 500 N over s = 1/2 a t^2, 100 N m over 1/2 (100/(m a^2/6)) t^2.
    EXPECT_NEAR(report.ledger.external, 500 * 0.5 * 0.25 + 100 * 0.5 * 0.3, 0.3);
    EXPECT_LT(std::abs(report.ledger.residual), 1e-9 * report.ledger.turnover);
    EXPECT_LT(norm(report.ledger.momentum_residual), 1e-12 * norm(report.ledger.impulse));
}

TEST(Kick, APointLoadPushesItsPointGrowsAndEndsAndItsWorkIsBooked) {
    SmallScene scene;
    const BodyId stone = scene.add("stone", scene.add_shape(box({1, 1, 1})), {});
    scene.add("bystander", scene.add_shape(box({1, 1, 1})), {{5, 0, 0}, {}});
    // 400 N on a corner, growing over 0.2 s from 0.1 s, until 0.5 s: an impulse of 400 (0.1 + 0.2) N s.
    scene.model.loads.push_back(
        {.body = stone, .force = {0, 400, 0}, .point = {0.5, 0, 0}, .start = 0.1, .ramp = 0.2, .stop = 0.5});
    const StepReport report = scene.run(1000, 1e-3);
    EXPECT_NEAR(scene.state.bodies.velocity[0].y, 120.0 / 2000, 1e-9);
    EXPECT_EQ(scene.state.bodies.velocity[1], Vec3{});
    // The arm turns with the body, by too little to matter here: 120 N s at 0.5 m on m a^2/6.
    EXPECT_NEAR(angular_velocity(scene.model.bodies, scene.state.bodies, stone).z, 60 / (2000.0 / 6), 1e-4);
    EXPECT_NEAR(report.ledger.external, report.ledger.kinetic, 1e-9 * report.ledger.kinetic);
    EXPECT_LT(std::abs(report.ledger.residual), 1e-9 * report.ledger.turnover);
    EXPECT_LT(norm(report.ledger.momentum_residual), 1e-12 * norm(report.ledger.impulse));
    EXPECT_LT(norm(report.ledger.angular_momentum_residual), 1e-9 * norm(report.ledger.impulse));
}

TEST(Kick, PointLoadsAddToLoadsFromOutside) {
    SmallScene scene;
    scene.add("stone", scene.add_shape(box({1, 1, 1})), {});
    scene.model.loads.push_back({.body = BodyId{0}, .force = {0, 0, 300}});
    initialise(scene.model, scene.state);
    Scratch scratch;
    const std::vector<Vec3> force{{0, 0, -300}}, torque{{0, 0, 0}};
    for (int i = 0; i < 10; ++i) {
        advance(scene.model, scene.state, scratch, 1e-3, Measure::flow, {force, torque});
    }
    EXPECT_EQ(scene.state.bodies.velocity[0], Vec3{});
}

TEST(Kick, APlanarBodyStaysInItsPlane) {
    SmallScene scene;
    scene.model.bodies.is_planar = true;
    scene.model.gravity.value = {0, -9.81, 3};
    scene.add("plate", scene.add_shape(box({1, 1, 1})), {}, body::Drive::free, {1, 0, 0}, {0, 0, 2});
    scene.run(500, 1e-3);
    EXPECT_EQ(scene.state.bodies.position[0].z, 0);
    EXPECT_EQ(scene.state.bodies.orientation[0].x, 0);
    EXPECT_EQ(scene.state.bodies.orientation[0].y, 0);
    EXPECT_NEAR(to_rotation_vector(scene.state.bodies.orientation[0]).z, 1.0, 1e-9);
}

TEST(Kick, ASpinFasterThanTheLimitIsNamed) {
    SmallScene scene;
    scene.add("top", scene.add_shape(box({1, 1, 1})), {}, body::Drive::free, {}, {0, 0, 1e9});
    EXPECT_NE(scene.run(1, 1e-6).status.text.find("top"), std::string::npos);
}

}  // namespace
}  // namespace riprap::sim
