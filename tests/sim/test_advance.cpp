// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/advance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "riprap/core/parallel.hpp"
#include "sim/small_scene.hpp"

namespace riprap::sim {
namespace {

using geometry::box;

TEST(Advance, FreeFallIsExactAtAnyStep) {
    SmallScene scene;
    scene.model.gravity.value = {0, 0, -9.81};
    scene.add("stone", scene.add_shape(box({1, 1, 1})), {{0, 0, 10.6}, {}}, body::Drive::free, {}, {1, 2, 3});
    // Falls 10.6 m in sqrt(2h/g) = 1.470054 s and then moves at 14.421234 m/s.
    const double fall_time = std::sqrt(2 * 10.6 / 9.81);
    scene.run(7, fall_time / 7);
    EXPECT_NEAR(scene.state.bodies.position[0].z, 0, 1e-13);
    EXPECT_NEAR(scene.state.bodies.velocity[0].z, -14.421234, 1e-6);
}

TEST(Advance, ABlockOnTheFloorIsHeldByItsWeight) {
    SmallScene scene;
    scene.model.gravity.value = {0, 0, -9.81};
    scene.rock().damping_ratio = 0.3;
    scene.mix();
    const ShapeId cube = scene.add_shape(box({1, 1, 1}));
    scene.add("floor", scene.add_shape(box({4, 4, 1})), {{0, 0, -0.5}, {}}, body::Drive::fixed);
    const BodyId block = scene.add("block", cube, {{0.3, -0.2, 0.5}, {}});
    initialise(scene.model, scene.state);
    Scratch scratch;
    const double dt = scene.automatic_step();
    for (int i = 0; i < 20000; ++i) {
        ASSERT_TRUE(advance(scene.model, scene.state, scratch, dt).status.ok());
    }
    const auto i = static_cast<std::size_t>(block.value);
    EXPECT_NEAR(scratch.contact_force()[i].z, 2000 * 9.81, 1e-6 * 2000 * 9.81);
    EXPECT_LT(norm(scene.state.bodies.velocity[i]), 1e-8);
}

/// Two cubes meet corner on, without friction or gravity.
SmallScene oblique_impact() {
    SmallScene scene;
    const ShapeId cube = scene.add_shape(box({1, 1, 1}));
    scene.add("left", cube, {{-1.2, 0, 0}, from_rotation_vector({0.3, 0.5, 0.2})}, body::Drive::free, {2, 0, 0},
              {0.5, -0.3, 0.8});
    scene.add("right", cube, {{0.5, 0.2, 0.1}, from_rotation_vector({-0.4, 0.1, 0.9})});
    return scene;
}

TEST(Advance, AFrictionlessImpactKeepsEnergyAndMomentum) {
    SmallScene scene = oblique_impact();
    initialise(scene.model, scene.state);
    Scratch scratch;
    const double dt = 0.45 * scene.automatic_step();  // corners of faces are stiff: the impact lasts 0.04 s
    const StepReport first = advance(scene.model, scene.state, scratch, dt);
    double most_elastic = 0;
    StepReport report;
    for (int i = 0; i < 5000; ++i) {
        report = advance(scene.model, scene.state, scratch, dt);
        ASSERT_TRUE(report.status.ok()) << report.status.text;
        most_elastic = std::max(most_elastic, report.ledger.elastic);
        ASSERT_LT(std::abs(report.ledger.residual), 1e-4 * first.ledger.kinetic);
    }
    EXPECT_GT(most_elastic, 0.05 * first.ledger.kinetic) << "the cubes never met";
    EXPECT_EQ(report.contact_count, 0);
    EXPECT_LT(norm(report.ledger.momentum - first.ledger.momentum), 1e-12 * norm(first.ledger.momentum));
    EXPECT_LT(norm(report.ledger.angular_momentum - first.ledger.angular_momentum),
              1e-11 * norm(first.ledger.angular_momentum));
}

TEST(Advance, TheEnergyErrorOfAnImpactFallsWithTheSquareOfTheStep) {
    const auto worst_residual = [](double dt) {
        SmallScene scene = oblique_impact();
        initialise(scene.model, scene.state);
        Scratch scratch;
        double worst = 0;
        for (double t = 0; t < 0.6; t += dt) {
            worst = std::max(worst, std::abs(advance(scene.model, scene.state, scratch, dt).ledger.residual));
        }
        return worst;
    };
    const double dt = oblique_impact().automatic_step();
    const double order = std::log2(worst_residual(dt) / worst_residual(dt / 2));
    EXPECT_GT(order, 1.7);
    EXPECT_LT(order, 2.6);
}

TEST(Advance, AnImpactRunBackwardsReturnsToItsStart) {
    SmallScene scene = oblique_impact();
    const State start = scene.state;
    const double dt = scene.automatic_step();
    const auto steps = static_cast<std::int64_t>(0.6 / dt);
    scene.run(steps, dt);
    for (std::size_t i = 0; i < 2; ++i) {
        scene.state.bodies.velocity[i] = -scene.state.bodies.velocity[i];
        scene.state.bodies.angular_momentum[i] = -scene.state.bodies.angular_momentum[i];
    }
    scene.run(steps, dt);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(norm(scene.state.bodies.position[i] - start.bodies.position[i]), 1e-10);
        EXPECT_LT(norm(to_rotation_vector(scene.state.bodies.orientation[i] * conjugate(start.bodies.orientation[i]))),
                  1e-10);
    }
}

/// Cubes and tetrahedra of several sizes fall into a box: contacts made and lost, friction and damping on.
SmallScene tumbling_pile() {
    SmallScene scene;
    scene.model.gravity.value = {0, 0, -9.81};
    scene.rock().friction = 0.5;
    scene.rock().damping_ratio = 0.05;
    scene.mix();
    scene.add("floor", scene.add_shape(box({20, 20, 1})), {{0, 0, -0.5}, {}}, body::Drive::fixed);
    const ShapeId shapes[] = {scene.add_shape(box({1, 1, 1})), scene.add_shape(box({0.4, 0.6, 0.3})),
                              scene.add_shape(geometry::regular_tetrahedron(1.0))};
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 60; ++i) {
        const Pose pose{{1.5 * (i % 4) - 2.2, 1.5 * (i / 4 % 4) - 2.2, 0.8 + 1.2 * (i / 16)},
                        from_rotation_vector({2 * unit(random), 2 * unit(random), 2 * unit(random)})};
        scene.add("block", shapes[i % 3], pose, body::Drive::free, {unit(random), unit(random), -3},
                  {0, unit(random), 1});
    }
    return scene;
}

TEST(Advance, StateHasTheSameBitsAtAnyThreadCount) {
    std::uint64_t hash = 0;
    for (const int threads : {1, 2, 3, 4}) {
        parallel::set_thread_count(threads);
        SmallScene scene = tumbling_pile();
        const StepReport report = scene.run(1200, scene.automatic_step());
        ASSERT_TRUE(report.status.ok()) << report.status.text;
        ASSERT_GT(report.contact_count, 15);
        if (threads == 1) {
            hash = state_hash(scene.state);
        }
        EXPECT_EQ(state_hash(scene.state), hash) << threads << " threads";
    }
    parallel::set_thread_count(1);
}

TEST(Advance, DroppingScratchBetweenStepsChangesNoBit) {
    SmallScene kept = tumbling_pile(), dropped = tumbling_pile();
    const double dt = kept.automatic_step();
    kept.run(700, dt);
    for (int i = 0; i < 100; ++i) {
        dropped.run(7, dt);  // every call starts with a fresh Scratch
    }
    EXPECT_EQ(state_hash(kept.state), state_hash(dropped.state));
}

TEST(Advance, AScratchOfAnotherStateChangesNoBit) {
    SmallScene first = tumbling_pile(), second = tumbling_pile();
    const double dt = first.automatic_step();
    first.run(400, dt);
    second.run(700, dt);
    const State restored = first.state;
    Scratch used;
    for (int i = 0; i < 50; ++i) {
        advance(second.model, second.state, used, dt);
    }
    // The driver steps back to an earlier State and keeps its Scratch.
    State retried = restored;
    for (int i = 0; i < 50; ++i) {
        advance(second.model, retried, used, dt);
    }
    first.run(50, dt);
    EXPECT_EQ(state_hash(retried), state_hash(first.state));
}

TEST(Advance, TheLedgerOfATumblingPileClosesWithoutBeingMadeTo) {
    SmallScene scene = tumbling_pile();
    const StepReport report = scene.run(6000, scene.automatic_step());
    ASSERT_TRUE(report.status.ok()) << report.status.text;
    EXPECT_GT(report.ledger.friction, 0.05 * report.ledger.turnover);
    EXPECT_LT(std::abs(report.ledger.residual), 0.01 * report.ledger.turnover);
    EXPECT_LT(norm(report.ledger.momentum_residual), 1e-10 * norm(report.ledger.impulse));
    EXPECT_LT(norm(report.ledger.angular_momentum_residual), 1e-9 * norm(report.ledger.angular_impulse));
}

TEST(Advance, ABlockSpinningOnItsFaceSlowsDownOnlyWithTorsionalFriction) {
    const auto spin_after = [](bool has_torsion, double time) {
        SmallScene scene;
        scene.model.gravity.value = {0, 0, -9.81};
        scene.rock().friction = 0.5;
        scene.rock().damping_ratio = 0.2;
        scene.rock().has_torsion = has_torsion;
        scene.mix();
        scene.add("floor", scene.add_shape(box({6, 6, 1})), {{0, 0, -0.5}, {}}, body::Drive::fixed);
        // Starts at the penetration that carries its weight: k_n (1/r_a + 1/r_b) d = rho g h.
        const double depth = 2000 * 9.81 * 1.0 / (1e7 * (2 + 2));
        const BodyId block = scene.add("block", scene.add_shape(box({1, 1, 1})), {{0, 0, 0.5 - depth}, {}},
                                       body::Drive::free, {}, {0, 0, 3});
        const double dt = scene.automatic_step();
        scene.run(static_cast<std::int64_t>(time / dt), dt);
        return angular_velocity(scene.model.bodies, scene.state.bodies, block).z;
    };
    EXPECT_NEAR(spin_after(false, 0.2), 3, 1e-3);
    // Even pressure on a square of side a: arm a (sqrt 2 + asinh 1)/6, moment of inertia m a^2/6, so 11.26 rad/s^2.
    const double deceleration = 0.5 * 9.81 * (std::numbers::sqrt2 + std::asinh(1.0));
    EXPECT_NEAR(spin_after(true, 0.2), 3 - 0.2 * deceleration, 0.01);
    EXPECT_NEAR(spin_after(true, 0.6), 0, 0.05);
}

TEST(Advance, AMovingWallWorksOnWhatItPushes) {
    SmallScene scene;
    const ShapeId cube = scene.add_shape(box({1, 1, 1}));
    scene.model.bodies.motions.push_back({body::LinearMotion{{1, 0, 0}}, 0, 1e9});
    const BodyId wall = scene.add("wall", cube, {{-1.05, 0, 0}, {}}, body::Drive::driven);
    drive(scene.model.bodies, wall, 0, {{-1.05, 0, 0}, {}});
    scene.add("block", cube, {});
    const StepReport report = scene.run(4000, scene.automatic_step());
    // An elastic push by an infinite mass: the block leaves at twice the wall's speed.
    EXPECT_NEAR(scene.state.bodies.velocity[1].x, 2, 1e-3);
    EXPECT_NEAR(report.ledger.driven, 0.5 * 2000 * 4, 1e-3 * 4000);
    EXPECT_LT(std::abs(report.ledger.residual), 1e-4 * report.ledger.driven);
}

TEST(Advance, AReleasedBodyStartsFromRestAtItsTime) {
    SmallScene scene;
    scene.model.gravity.value = {0, 0, -10};
    const BodyId held = scene.add("held", scene.add_shape(box({1, 1, 1})), {{0, 0, 5}, {}}, body::Drive::fixed);
    scene.model.bodies.release_time[static_cast<std::size_t>(held.value)] = 0.5;
    const StepReport report = scene.run(1000, 1e-3);
    EXPECT_NEAR(scene.state.bodies.position[0].z, 5 - 0.5 * 10 * 0.25, 0.01);
    EXPECT_LT(std::abs(report.ledger.residual), 1e-9 * report.ledger.turnover);
    EXPECT_LT(norm(report.ledger.momentum_residual), 1e-9 * norm(report.ledger.impulse));
}

TEST(Advance, ATurningGravityIsBookedAsWork) {
    SmallScene scene;
    scene.model.gravity = {.value = {0, 0, -10}, .ramp = 0.3, .axis = {0, 1, 0}, .rate = 2};
    scene.add("block", scene.add_shape(box({1, 1, 1})), {{1, 2, 3}, {}});
    const StepReport report = scene.run(1000, 1e-3);
    EXPECT_GT(std::abs(report.ledger.gravity_change), 1.0);
    EXPECT_LT(std::abs(report.ledger.residual), 1e-5 * report.ledger.turnover);
}

TEST(Advance, TheTurnoverOfAFlightIsWhatItExchangedWhereverTheOriginLies) {
    // Up and down again under a gravity that turns: far from the origin the work of turning it is a thousand times the
    // energy that the block ever had.
    const auto turnover_at = [](const Vec3& place) {
        SmallScene scene;
        scene.model.gravity = {.value = {0, 0, -10}, .axis = {0, 1, 0}, .rate = 0.5};
        scene.add("block", scene.add_shape(box({1, 1, 1})), {place, {}}, body::Drive::free, {0, 0, 5});
        return scene.run(1000, 1e-3).ledger.turnover;
    };
    EXPECT_GT(turnover_at({}), 0.5 * 2000 * 25 * 0.9);
    EXPECT_NEAR(turnover_at({1e4, -2e4, 3e4}) / turnover_at({}), 1, 1e-3);
}

TEST(Advance, TheTurnoverKeepsWhatAnEnergyOnceWas) {
    // A block thrown up and caught at the top has no energy of motion left, and the push of a wall is long over.
    SmallScene scene;
    scene.model.gravity.value = {0, 0, -10};
    scene.add("block", scene.add_shape(box({1, 1, 1})), {}, body::Drive::free, {0, 0, 5});
    const StepReport top = scene.run(500, 1e-3);
    EXPECT_NEAR(top.ledger.kinetic, 0, 1);
    EXPECT_NEAR(top.ledger.turnover, 0.5 * 2000 * 25, 150);
}

TEST(Advance, ANonFiniteVelocityIsNamedWithinOneStep) {
    SmallScene scene;
    scene.add("pebble", scene.add_shape(box({1, 1, 1})), {});
    scene.state.bodies.velocity[0].y = std::numeric_limits<double>::quiet_NaN();
    const StepReport report = scene.run(1, 1e-3);
    EXPECT_THAT(report.status.text, testing::HasSubstr("pebble"));
}

TEST(Advance, AnOverlapBeyondTheAllowedPotentialIsNamedWithBothBodies) {
    SmallScene scene;
    scene.model.dem()->max_potential = 0.3;
    const ShapeId cube = scene.add_shape(box({1, 1, 1}));
    scene.add("one", cube, {});
    scene.add("two", cube, {{0.7, 0, 0}, {}});
    const StepReport report = scene.run(1, 1e-6);
    EXPECT_THAT(report.status.text, testing::AllOf(testing::HasSubstr("one"), testing::HasSubstr("two")));
}

TEST(Advance, AStepAboveTheBoundIsRefusedUnlessForced) {
    SmallScene scene;
    scene.add("cube", scene.add_shape(box({1, 1, 1})), {});
    const TimeStepBound bound = time_step_bound(scene.model);
    // Frictionless cubes in a lattice: dt = (a/2) sqrt(rho/k_n).
    EXPECT_NEAR(bound.limit, 0.5 * std::sqrt(2000 / 1e7), 1e-12);
    scene.model.time.time_step = 1.01 * bound.limit;
    EXPECT_THROW(largest_time_step(scene.model, bound), CaseError);
    scene.model.time.force_time_step = true;
    EXPECT_EQ(largest_time_step(scene.model, bound), scene.model.time.time_step);
}

}  // namespace
}  // namespace riprap::sim
