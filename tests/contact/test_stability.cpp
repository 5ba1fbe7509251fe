// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/stability.hpp"

#include <gtest/gtest.h>

#include <random>

namespace riprap::contact {
namespace {

/// A free body about the origin.
struct Body {
    Frame frame{};
    material::Material material{};
    Vec3 center{}, velocity{}, spin{};
    double inverse_mass;
    Sym3 inverse_inertia;

    PairSide side() const { return {0, 0, {}, frame, material, center, velocity, spin, inverse_mass, inverse_inertia}; }
};

/// Unit cube of mass 1: J = 1/6.
Body cube() { return {.inverse_mass = 1, .inverse_inertia = {6, 6, 6, 0, 0, 0}}; }
Body wall() { return {.inverse_mass = 0, .inverse_inertia = {}}; }

/// Largest eigenvalue of W K by the power method, W from its definition.
double largest_eigenvalue(const Body& body, const Vec3& point, const Vec3& n, double along, double across) {
    Vec3 v{0.3, 0.5, 0.7};
    double value = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 force = across * v + (along - across) * dot(n, v) * n;
        const Vec3 r = point - body.center;
        v = body.inverse_mass * force + cross(body.inverse_inertia * cross(r, force), r);
        value = norm(v);
        v = v / value;
    }
    return value;
}

TEST(Stability, ACubePressedCentrallyOnAFixedFloorCountsItsNormalSpringAlone) {
    const Body block = cube(), floor = wall();
    const Vec3 n{0, 0, -1};
    ContactRow row{};
    // Frictionless, at the centre of the face: omega^2 = K/m.
    set_stability({.normal_stiffness = 100}, mobility_at(block.side(), {0, 0, -0.5}, n),
                  mobility_at(floor.side(), {0, 0, -0.5}, n), row);
    EXPECT_NEAR(row.omega_squared_a, 100, 1e-4);
    EXPECT_EQ(row.omega_squared_b, 0);
    EXPECT_EQ(row.damping_a, 0);
}

TEST(Stability, TheShearSpringOfAStandingCubeIsItsStiffestMode) {
    const Body block = cube(), floor = wall();
    const Vec3 n{0, 0, -1};
    ContactRow row{};
    // A push across the face also turns the cube: 1/m + (a/2)^2/J = 1 + 0.25 * 6 = 2.5, in two directions.
    set_stability({.normal_stiffness = 100, .shear_stiffness = 80, .normal_damping = 4, .shear_damping = 3},
                  mobility_at(block.side(), {0, 0, -0.5}, n), mobility_at(floor.side(), {0, 0, -0.5}, n), row);
    EXPECT_GE(row.omega_squared_a, 200);
    EXPECT_LE(row.omega_squared_a, 245);  // the bound by traces is not exact where the two largest are equal
    EXPECT_GE(row.damping_a, 7.5);
    EXPECT_LE(row.damping_a, 9.2);
}

TEST(Stability, TheShareOfAContactIsNeverBelowItsLargestEigenvalue) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 200; ++i) {
        Body body{.inverse_mass = 1, .inverse_inertia = {6, 3, 9, uniform(random), uniform(random), uniform(random)}};
        const Vec3 point{uniform(random), uniform(random), uniform(random)};
        const Vec3 n = normalized(Vec3{uniform(random), uniform(random), uniform(random)});
        const double across = 60 * (1 + uniform(random));
        const double exact = largest_eigenvalue(body, point, n, 100, across);
        ContactRow row{};
        set_stability({.normal_stiffness = 100, .shear_stiffness = across}, mobility_at(body.side(), point, n),
                      mobility_at(wall().side(), point, n), row);
        EXPECT_GE(row.omega_squared_a, exact * (1 - 1e-6));
        EXPECT_LE(row.omega_squared_a, exact * 1.35);
    }
}

TEST(Stability, TwoEqualBodiesShareASpring) {
    const Body block = cube();
    const Vec3 n{0, 0, 1};
    ContactRow row{};
    const Mobility w = mobility_at(block.side(), {}, n);
    set_stability({.normal_stiffness = 100, .torsion_stiffness = 10}, w, w, row);
    // Against each other: 2 K/m, and 2 K_t/J about the normal.
    EXPECT_NEAR(row.omega_squared_a, 200 + 120, 1e-3);
    EXPECT_EQ(row.omega_squared_a, row.omega_squared_b);
}

/// Tells whether x'' = -omega^2 x - damping x' grows when its dashpot takes the velocity before the kick.
bool grows(double omega_squared, double damping, double dt) {
    double x = 1, v = 0;
    for (int i = 0; i < 4000; ++i) {
        v -= dt * (omega_squared * x + damping * v);
        x += dt * v;
        if (std::abs(x) > 1e6) {
            return true;
        }
    }
    return false;
}

TEST(Stability, TheStableStepIsTheLimitOfADampedOscillator) {
    for (const double ratio : {0.0, 0.1, 0.5, 1.0, 3.0}) {
        const double omega = 7, damping = 2 * ratio * omega;
        const double limit = stable_step(omega * omega, damping);
        EXPECT_FALSE(grows(omega * omega, damping, 0.99 * limit)) << ratio;
        EXPECT_TRUE(grows(omega * omega, damping, 1.01 * limit)) << ratio;
    }
    EXPECT_EQ(stable_step(0, 0), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace riprap::contact
