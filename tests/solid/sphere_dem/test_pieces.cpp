// SPDX-License-Identifier: Apache-2.0
// Pieces that scenes of spheres rest on, each beside its exact answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "riprap/solid/sphere_dem/sphere_world.hpp"

namespace riprap::solid::sphere_dem {
namespace {

/// Two spheres that meet head on at 2 m/s: speed of parting over that of approach, time of contact, deepest overlap.
struct HeadOn {
    double restitution{0}, duration{0}, overlap{0};
};

constexpr double modulus = 1e8, poisson_ratio = 0.3, radius = 0.01, mass = 0.01, half_speed = 1;

HeadOn head_on(double restitution) {
    SphereWorld world;
    const MaterialId grain =
        world.add_material({.youngs_modulus = modulus, .poisson_ratio = poisson_ratio, .restitution = restitution});
    world.add_sphere(grain, radius, mass, {{{0, 0, 0}, {}}, {half_speed, 0, 0}, {}});
    world.add_sphere(grain, radius, mass, {{{2 * radius + 1e-7, 0, 0}, {}}, {-half_speed, 0, 0}, {}});
    world.settings.steps_per_contact = 400;
    world.build();
    const double dt = world.step_limit();
    HeadOn result;
    for (int step = 0; step < 100'000 && (result.duration == 0 || world.report.contact_count > 0); ++step) {
        world.step(dt);
        result.duration += world.report.contact_count > 0 ? dt : 0;
        result.overlap = std::max(result.overlap, 2 * radius - norm(world.state.position[1] - world.state.position[0]));
    }
    result.restitution = (world.state.velocity[1].x - world.state.velocity[0].x) / (2 * half_speed);
    return result;
}

TEST(SphereImpacts, HeadOnPartByTheirRestitutionAndLastAsLongAsHertzSays) {
    for (const double e : {0.3, 0.5, 0.7, 0.95}) {
        EXPECT_NEAR(head_on(e).restitution, e, 0.005 * e);
    }
    const HeadOn elastic = head_on(1);
    const double effective = modulus / (2 * (1 - poisson_ratio * poisson_ratio));
    EXPECT_NEAR(elastic.duration /
                    (2.87 * std::pow(std::pow(0.5 * mass / effective, 2) / (0.5 * radius * 2 * half_speed), 0.2)),
                1, 0.03);
    EXPECT_NEAR(
        elastic.overlap /
            std::pow(15 * 0.5 * mass * std::pow(2 * half_speed, 2) / (16 * effective * std::sqrt(0.5 * radius)), 0.4),
        1, 0.005);
}

// It turns once a second about its middle axis and tumbles, 10 000 steps of 1 ms.
TEST(Multisphere, AFreeBoxOfUnequalEdgesTumblesWithoutLossAndItsQuaternionKeepsItsLength) {
    SphereWorld world;
    const MaterialId grain = world.add_material({.youngs_modulus = 1e8});
    world.add_multisphere(grain, body::box_shell({0.4, 0.2, 0.1}, 0.05).value(), 1000,
                          {{{0, 0, 0}, {}}, {}, {0.3, 6, 0.2}});
    world.build();
    const auto energy = [&] {
        return 0.5 * dot(world.state.angular_momentum[0], angular_velocity(world.bodies, world.state, BodyId{0}));
    };
    const double size = norm(world.state.angular_momentum[0]), start = energy();
    double drift = 0, growth = 0, stretch = 0;
    for (int step = 0; step < 10'000; ++step) {
        world.step(1e-3);
        drift = std::max(drift, std::abs(norm(world.state.angular_momentum[0]) / size - 1));
        growth = std::max(growth, std::abs(energy() / start - 1));
        const Quat& q = world.state.orientation[0];
        stretch = std::max(stretch, std::abs(std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z) - 1));
    }
    EXPECT_LE(drift, 1e-10);
    EXPECT_LE(growth, 1e-6);
    EXPECT_LE(stretch, 1e-12);
}

/// Angle after a second of a spin of 1.7 rad/s about z [rad].
double turned(bool is_planar) {
    SphereWorld one;
    const MaterialId material = one.add_material({.youngs_modulus = 1e8});
    one.bodies.is_planar = is_planar;
    const Start spin{{}, {}, {0, 0, 1.7}};
    if (is_planar) {
        one.add_disc(material, 0.1, 1, spin);
    } else {
        one.add_sphere(material, 0.1, 1, spin);
    }
    one.build();
    for (int step = 0; step < 1000; ++step) {
        one.step(1e-3);
    }
    const Quat& q = one.state.orientation[0];
    return 2 * std::atan2(q.z, q.w);
}

TEST(SphereWorld, ASteadySpinTurnsByItsRateInThePlaneAndInSpace) {
    EXPECT_NEAR(turned(true), 1.7, 1e-10);
    EXPECT_NEAR(turned(false), 1.7, 1e-10);
}

}  // namespace
}  // namespace riprap::solid::sphere_dem
