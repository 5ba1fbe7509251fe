// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "riprap/contact/law/hertz.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/solid/sphere_dem/sphere_world.hpp"

namespace riprap::solid::sphere_dem {
namespace {

constexpr double hard = 1e18;  ///< [Pa], beside which a material is rigid

/// A sphere of radius 1 cm and 10 g that meets the plane z = 0.
struct Throw {
    contact::ContactMaterial material{.youngs_modulus = 1e8, .poisson_ratio = 0.3};
    Vec3 velocity{0, 0, -1}, spin{};
    double steps_per_contact{200};
    bool allows_pull{true};
};

SphereWorld thrown(const Throw& t) {
    SphereWorld world;
    const MaterialId grain = world.add_material(t.material);
    contact::ContactMaterial rigid = t.material;
    rigid.youngs_modulus = hard;
    const MaterialId plate = world.add_material(rigid);
    world.add_plane(plate, {0, 0, 1}, {});
    world.add_sphere(grain, 0.01, 0.01, {{{0, 0, 0.0100001}, {}}, t.velocity, t.spin});
    world.settings.steps_per_contact = t.steps_per_contact;
    world.settings.allows_pull = t.allows_pull;
    world.build();
    return world;
}

/// Steps until the sphere has left the plane.
void bounce(SphereWorld& world) {
    const double dt = world.step_limit();
    bool has_touched = false;
    for (int step = 0; step < 100000; ++step) {
        world.step(dt);
        has_touched = has_touched || world.report.contact_count > 0;
        if (has_touched && world.report.contact_count == 0) {
            return;
        }
    }
    FAIL() << "the sphere has not come back";
}

Vec3 spin_of(const SphereWorld& world, std::int32_t body) {
    return angular_velocity(world.bodies, world.state, BodyId{body});
}

TEST(SphereImpact, ASphereLeavesAPlaneWithTheRestitutionOfTheMaterial) {
    for (const double e : {0.3, 0.65, 0.95}) {
        Throw t;
        t.material.restitution = e;
        SphereWorld world = thrown(t);
        bounce(world);
        EXPECT_NEAR(world.state.velocity[1].z, e, 0.005 * e);
    }
}

TEST(SphereImpact, RestitutionDoesNotDependOnTheStepUpToAFiftiethOfTheImpact) {
    Throw fine, coarse;
    fine.material.restitution = coarse.material.restitution = 0.65;
    fine.steps_per_contact = 2000;
    coarse.steps_per_contact = 50;
    SphereWorld one = thrown(fine), two = thrown(coarse);
    bounce(one);
    bounce(two);
    EXPECT_NEAR(two.state.velocity[1].z, one.state.velocity[1].z, 0.01);
}

// Gross sliding [Chung and Ooi 2011, test 4]: impulse mu (1+e) m v_n across the normal.
TEST(SphereImpact, ObliqueSlidingImpactsTakeTheImpulseOfCoulombFriction) {
    for (const auto& [mu, e, nu] :
         {std::array{0.1, 0.98, 0.25}, std::array{0.25, 0.6, 0.3}, std::array{0.4, 1.0, 0.0}}) {
        Throw t;
        t.material.youngs_modulus = 1e13;  // the arm of the friction is the radius less the overlap
        t.material.static_friction = mu;
        t.material.restitution = e;
        t.material.poisson_ratio = nu;
        t.allows_pull = false;
        t.velocity = {8, 0, -1};
        t.steps_per_contact = 1000;
        SphereWorld world = thrown(t);
        bounce(world);
        const double e_out = world.state.velocity[1].z, impulse = mu * (1 + e_out);
        EXPECT_NEAR(8 - world.state.velocity[1].x, impulse, 1e-3 * impulse);
        EXPECT_NEAR(spin_of(world, 1).y, 2.5 * impulse / 0.01, 1e-3 * 250 * impulse);
    }
}

TEST(SphereImpact, ASpinningSphereKeepsItsAngularMomentumAboutTheContactPoint) {
    Throw t;
    t.material.static_friction = 0.3;
    t.material.restitution = 0.9;
    t.spin = {0, 20, 0};
    SphereWorld world = thrown(t);
    const double moment = 0.4 * 0.01 * 1e-4, before = moment * 20;
    bounce(world);
    // The arm of the friction is the radius less the overlap; about the plane itself momentum is exact.
    double height = 0.0100001;
    const double after = moment * spin_of(world, 1).y + height * 0.01 * world.state.velocity[1].x;
    EXPECT_NEAR(after, before, 1e-2 * before);
    EXPECT_GT(world.state.velocity[1].x, 0.01);
}

SphereWorld pair_of(const contact::ContactMaterial& material, double radius_b, double mass_b) {
    SphereWorld world;
    const MaterialId grain = world.add_material(material);
    world.add_sphere(grain, 0.01, 0.01, {{{0, 0, 0}, {}}, {1, 0.4, 0}, {0, 0, 3}});
    world.add_sphere(grain, radius_b, mass_b, {{{0.0100001 + radius_b, 0, 0}, {}}, {}, {0, 5, 0}});
    world.settings.steps_per_contact = 100;
    world.build();
    return world;
}

TEST(SphereImpact, APairKeepsMomentumAndAngularMomentumToRoundOff) {
    contact::ContactMaterial rough{.youngs_modulus = 1e7, .restitution = 0.5, .static_friction = 0.4};
    rough.rolling_friction = 0.1;
    for (const auto rolling : {contact::RollingLaw::none, contact::RollingLaw::constant, contact::RollingLaw::spring}) {
        SphereWorld world = pair_of(rough, 0.02, 0.08);
        world.settings.rolling = rolling;
        const auto momenta = [&] {
            Vec3 p{}, l{};
            for (std::size_t b = 0; b < 2; ++b) {
                p += world.bodies.mass[b] * world.state.velocity[b];
                l += cross(world.state.position[b], world.bodies.mass[b] * world.state.velocity[b]) +
                     world.state.angular_momentum[b];
            }
            return std::array{p, l};
        };
        const auto before = momenta();
        const double dt = world.step_limit();
        for (int step = 0; step < 300; ++step) {
            world.step(dt);
        }
        const auto after = momenta();
        EXPECT_EQ(world.report.contact_count, 0);
        EXPECT_NEAR(norm(after[0] - before[0]), 0, 1e-12 * norm(before[0]));
        EXPECT_NEAR(norm(after[1] - before[1]), 0, 1e-12 * norm(before[1]));
        EXPECT_LT(world.state.velocity[0].x, 1);
    }
}

TEST(SphereImpact, ALargeSphereIsAPlaneInTheLimit) {
    contact::ContactMaterial material{.youngs_modulus = 1e7, .restitution = 0.7, .static_friction = 0.1};
    SphereWorld world = pair_of(material, 100, 1e9);
    const double dt = world.step_limit();
    for (int step = 0; step < 400; ++step) {
        world.step(dt);
    }
    EXPECT_EQ(world.report.contact_count, 0);
    EXPECT_NEAR(world.state.velocity[0].x, -0.7, 0.005);
}

TEST(SphereImpact, SpheresThatSpinAsGearsDoNotSlip) {
    SphereWorld world;
    const MaterialId grain = world.add_material({.youngs_modulus = 1e7, .static_friction = 0.5});
    world.add_sphere(grain, 0.01, 0.01, {{{0, 0, 0}, {}}, {1, 0, 0}, {0, 0, 7}});
    world.add_sphere(grain, 0.01, 0.01, {{{0.0200001, 0, 0}, {}}, {-1, 0, 0}, {0, 0, -7}});
    world.build();
    const double dt = world.step_limit();
    for (int step = 0; step < 200; ++step) {
        world.step(dt);
    }
    EXPECT_NEAR(world.state.velocity[0].x, -1, 2e-3);
    EXPECT_NEAR(world.state.velocity[0].y, 0, 1e-12);
    EXPECT_NEAR(spin_of(world, 0).z, 7, 1e-10);
    EXPECT_NEAR(spin_of(world, 1).z, -7, 1e-10);
}

TEST(SphereImpact, ABouncingBallLosesOnlyWhatItsBooksSay) {
    Throw t;
    t.material.restitution = 0.8;
    t.material.static_friction = 0.3;
    t.velocity = {1, 0, -1};
    SphereWorld world = thrown(t);
    world.gravity = {0, 0, -9.81};
    const double dt = world.step_limit();
    world.step(dt);
    const double before = world.energy_account(), scale = world.report.kick.kinetic;
    double worst = 0;
    for (int step = 0; step < 20000; ++step) {
        world.step(dt);
        worst = std::max(worst, std::abs(world.energy_account() - before));
    }
    EXPECT_LT(worst, 0.01 * scale);
    EXPECT_GT(world.contacts.friction_loss, 0.05 * scale);
    EXPECT_GT(world.contacts.damping_loss, 0.1 * scale);
}

// B4: rolling without slip down 20 degrees, 5/7 g sin; B5: v = 5/7 v_0 once it rolls.
TEST(SphereRolling, ASphereRollsDownASlopeAndTakesUpRollingAsRigidMechanicsSays) {
    const double slope = 20 * M_PI / 180;
    SphereWorld world;
    const MaterialId grain = world.add_material({.youngs_modulus = 1e8, .restitution = 0.5, .static_friction = 0.4});
    world.add_plane(grain, {0, 0, 1}, {});
    world.add_sphere(grain, 0.01, 0.01, {{{0, 0, 0.01}, {}}, {}, {}});
    world.gravity = {9.81 * std::sin(slope), 0, -9.81 * std::cos(slope)};
    world.build();
    const double dt = world.step_limit();
    while (world.time < 0.5) {
        world.step(dt);
    }
    EXPECT_NEAR(world.state.velocity[1].x, 5.0 / 7 * 9.81 * std::sin(slope) * world.time, 2e-3 * 1.2);

    SphereWorld sliding;
    const MaterialId smooth = sliding.add_material({.youngs_modulus = 1e8, .restitution = 0.5, .static_friction = 0.2});
    sliding.add_plane(smooth, {0, 0, 1}, {});
    const double rest =
        std::pow(0.01 * 9.81 / (4.0 / 3 * contact::effective_modulus({1e8, 0.3}, {1e8, 0.3}) * 0.1), 2.0 / 3);
    sliding.add_sphere(smooth, 0.01, 0.01, {{{0, 0, 0.01 - rest}, {}}, {1, 0, 0}, {}});
    sliding.gravity = {0, 0, -9.81};
    sliding.build();
    while (sliding.time < 0.3) {
        sliding.step(dt);
    }
    EXPECT_NEAR(sliding.state.velocity[1].x, 5.0 / 7, 0.005 * 5 / 7);
}

TEST(SphereRolling, ARollingSpringHoldsASphereOnASlopeBelowItsLimit) {
    SphereWorld world;
    contact::ContactMaterial material{.youngs_modulus = 1e7, .restitution = 0.3, .static_friction = 0.5};
    material.rolling_friction = 0.2;
    const MaterialId grain = world.add_material(material);
    world.add_plane(grain, {0, 0, 1}, {});
    world.add_sphere(grain, 0.01, 0.01, {{{0, 0, 0.00999}, {}}, {}, {}});
    world.settings.rolling = contact::RollingLaw::spring;
    world.gravity = {0.15 * 9.81, 0, -9.81};
    world.build();
    const double dt = world.step_limit();
    while (world.time < 0.3) {
        world.step(dt);
    }
    EXPECT_LT(std::abs(world.state.position[1].x), 0.001);
}

}  // namespace
}  // namespace riprap::solid::sphere_dem
