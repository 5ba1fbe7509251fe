// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "riprap/core/parallel.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/solid/sphere_dem/sphere_world.hpp"
#include "riprap/solid/sphere_dem/time_step.hpp"

namespace riprap::solid::sphere_dem {
namespace {

struct CubeDrop {
    int spheres{2};  ///< along an edge
    contact::Sharing sharing{contact::Sharing::dashpots};
    bool on_spheres{false};  ///< the ground is a shell of spheres as well
};

/// Restitution of a cube of 0.5 m and 150 kg that falls face down at 3.52 m/s.
double cube_restitution(const CubeDrop& drop) {
    SphereWorld world;
    const MaterialId wood = world.add_material({.youngs_modulus = 7e7, .poisson_ratio = 0.1, .restitution = 0.65});
    const body::Multisphere cube = body::box_shell({0.5, 0.5, 0.5}, drop.spheres).value();
    if (drop.on_spheres) {
        const BodyId ground = world.add_multisphere(wood, cube, 1200, {{{0, 0, -0.25}, {}}, {}, {}});
        world.bodies.drive[static_cast<std::size_t>(ground.value)] = body::Drive::fixed;
    } else {
        world.add_plane(wood, {0, 0, 1}, {});
    }
    world.add_multisphere(wood, cube, 1200, {{{0, 0, 0.2501}, {}}, {0, 0, -3.52}, {}});
    world.settings.sharing = drop.sharing;
    world.build();
    const double dt = world.step_limit();
    bool has_touched = false;
    for (int step = 0; step < 20000; ++step) {
        world.step(dt);
        has_touched = has_touched || world.report.contact_count > 0;
        if (has_touched && world.report.contact_count == 0) {
            if (drop.sharing != contact::Sharing::closest) {  // which acts at one corner of equal ones
                EXPECT_NEAR(norm(world.state.angular_momentum[1]), 0, 1e-8);
            }
            return world.state.velocity[1].z / 3.52;
        }
    }
    return std::nan("");
}

TEST(Multisphere, AFlatCubeReboundsTheSameHoweverManySpheresItHas) {
    for (const int n : {2, 4, 8}) {  // 8, 64, 512 spheres
        EXPECT_NEAR(cube_restitution({n}), 0.65, 0.02 * 0.65) << n;
        EXPECT_NEAR(cube_restitution({n, contact::Sharing::dashpots, true}), 0.65, 0.02 * 0.65) << n;
        EXPECT_NEAR(cube_restitution({n, contact::Sharing::divide}), 0.65, 0.02 * 0.65) << n;
        EXPECT_NEAR(cube_restitution({n, contact::Sharing::closest}), 0.65, 0.02 * 0.65) << n;
    }
}

// N equal contacts that all count in full have sqrt(N) times the contact ratio.
TEST(Multisphere, CountingEveryContactInFullLosesSpeedWithTheNumberOfSpheres) {
    EXPECT_NEAR(cube_restitution({1, contact::Sharing::sum}), 0.650, 0.01);
    EXPECT_NEAR(cube_restitution({2, contact::Sharing::sum}), 0.412, 0.01);
}

TEST(Multisphere, ATwoSphereClumpDroppedFlatBouncesWithItsRestitutionAndNoSpin) {
    SphereWorld world;
    const MaterialId grain = world.add_material({.youngs_modulus = 1e8, .restitution = 0.7});
    world.add_plane(grain, {0, 0, 1}, {});
    body::Multisphere clump;
    clump.spheres = {{{-0.008, 0, 0}, 0.01, {}}, {{0.008, 0, 0}, 0.01, {}}};
    world.add_multisphere(grain, clump, 2500, {{{0, 0, 0.01001}, {}}, {0, 0, -1}, {}});
    world.build();
    const double dt = world.step_limit();
    while (world.state.velocity[1].z < 0 || world.report.contact_count > 0) {
        world.step(dt);
    }
    EXPECT_NEAR(world.state.velocity[1].z, 0.7, 0.005);
    EXPECT_NEAR(norm(angular_velocity(world.bodies, world.state, BodyId{1})), 0, 1e-8);
}

/// Grains thrown into a box: spheres of two sizes, clumps, a block of plane faces that can move.
SphereWorld mixture(int count) {
    SphereWorld world;
    const MaterialId grain = world.add_material(
        {.youngs_modulus = 1e7, .restitution = 0.5, .static_friction = 0.4, .rolling_friction = 0.05});
    const MaterialId wall = world.add_material({.youngs_modulus = 5e7, .restitution = 0.7, .static_friction = 0.2});
    world.add_plane(wall, {0, 0, 1}, {});
    world.add_plane(wall, {1, 0, 0}, {-0.1, 0, 0});
    world.add_plane(wall, {-1, 0, 0}, {0.1, 0, 0});
    world.add_plane(wall, {0, 1, 0}, {0, -0.1, 0});
    world.add_plane(wall, {0, -1, 0}, {0, 0.1, 0});
    std::mt19937_64 bits(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    body::Multisphere clump;
    clump.spheres = {{{-0.006, 0, 0}, 0.008, {}}, {{0.006, 0, 0}, 0.008, {}}, {{0, 0.008, 0}, 0.006, {}}};
    for (int k = 0; k < count; ++k) {
        const Vec3 place{-0.075 + 0.03 * (k % 6), -0.075 + 0.03 * (k / 6 % 6), 0.02 + 0.032 * (k / 36)};
        const Start start{{place, {}},
                          Vec3{0, 0, -1.5} + 0.5 * Vec3{unit(bits), unit(bits), unit(bits)},
                          20.0 * Vec3{unit(bits), unit(bits), 0}};
        if (k % 3 == 0) {
            world.add_multisphere(grain, clump, 2500, start);
        } else {
            const double radius = k % 3 == 1 ? 0.01 : 0.013;
            world.add_sphere(grain, radius, 2500 * 4.0 / 3 * M_PI * radius * radius * radius, start);
        }
    }
    world.gravity = {0, 0, -9.81};
    world.settings.rolling = contact::RollingLaw::spring;
    world.build();
    return world;
}

std::uint64_t hash_of(const SphereWorld& world) { return hash_fields(world.state) ^ (hash_fields(world.contacts) * 3); }

TEST(SphereBits, AMixtureHasTheSameBitsAtAnyNumberOfThreadsAndWithoutItsScratch) {
    const int before = parallel::thread_count();
    std::uint64_t expected = 0;
    for (const int threads : {1, 2, 4}) {
        parallel::set_thread_count(threads);
        SphereWorld world = mixture(72);
        const double dt = world.step_limit();
        for (int step = 0; step < 600; ++step) {
            world.step(dt);
            if (threads == 2 && step % 100 == 57) {
                world.scratch = {};
            }
        }
        EXPECT_GT(world.report.contact_count, 10);
        EXPECT_EQ(world.report.problem, "");
        expected = threads == 1 ? hash_of(world) : expected;
        EXPECT_EQ(hash_of(world), expected) << threads;
    }
    parallel::set_thread_count(before);
}

TEST(SphereBits, AStateThatIsPutBackRunsOnAsItDidBefore) {
    SphereWorld world = mixture(36);
    const double dt = 0.5 * world.step_limit();
    for (int step = 0; step < 500; ++step) {
        world.step(dt);
    }
    const body::BodyState bodies = world.state;
    const SphereState contacts = world.contacts;
    const double time = world.time;
    for (int step = 0; step < 200; ++step) {
        world.step(dt);
    }
    const std::uint64_t first = hash_of(world);
    world.state = bodies;
    world.contacts = contacts;
    world.time = time;
    for (int step = 0; step < 200; ++step) {
        world.step(dt);
    }
    EXPECT_EQ(hash_of(world), first);
}

TEST(SphereBooks, AMixtureComesToRestAndItsBooksClose) {
    SphereWorld world = mixture(72);
    const double dt = world.step_limit();
    world.step(dt);
    const double start = world.energy_account();
    double turnover = world.report.kick.kinetic;
    const double height = world.report.kick.potential;
    while (world.time < 0.45) {
        world.step(dt);
        ASSERT_EQ(world.report.problem, "");
    }
    turnover += height - world.report.kick.potential;
    EXPECT_LT(world.report.kick.kinetic, 0.01 * turnover);
    EXPECT_NEAR(world.energy_account(), start, 0.02 * turnover);
    for (std::size_t s = 0; s < world.spheres.radius.size(); ++s) {
        EXPECT_GT(world.scratch.placed.center[s].z, 0.9 * world.spheres.radius[s]);
    }
}

TEST(SphereWalls, ASphereRestsOnFaceEdgeAndCornerOfABlockAtItsRadius) {
    const double diagonal = std::sqrt(2.0) / 2;
    for (const Vec3& direction : {Vec3{0, 0, 1}, Vec3{0, diagonal, diagonal}, normalized(Vec3{1, 1, 1})}) {
        SphereWorld world;
        const MaterialId grain = world.add_material({.youngs_modulus = 1e8, .restitution = 0.3});
        const Vec3 nearest{0.1 * std::round(std::abs(direction.x) + 0.3), 0.1 * std::round(std::abs(direction.y) + 0.3),
                           0.1};
        world.add_wall(grain, world.shapes.add_convex(geometry::cube(0.2)));
        world.add_sphere(grain, 0.02, 0.05, {{nearest + 0.0199 * direction, {}}, {}, {}});
        world.gravity = -9.81 * direction;
        world.build();
        const double dt = world.step_limit();
        for (int step = 0; step < 10000; ++step) {
            world.step(dt);
        }
        EXPECT_EQ(world.report.contact_count, 1);
        EXPECT_NEAR(dot(world.state.position[1] - nearest, direction), 0.02, 2e-5);
    }
}

TEST(SphereWalls, ASphereCrossesTheSeamOfTwoTrianglesAsIfThereWereNone) {
    const auto cross_floor = [](bool is_surface) {
        SphereWorld world;
        const MaterialId grain =
            world.add_material({.youngs_modulus = 1e8, .restitution = 0.4, .static_friction = 0.3});
        if (is_surface) {
            world.add_surface(grain, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0, 1, 2, 0, 2, 3});
        } else {
            world.add_plane(grain, {0, 0, 1}, {});
        }
        world.add_sphere(grain, 0.02, 0.05, {{{-0.1, 0.05, 0.02}, {}}, {1, -0.4, 0}, {}});
        world.gravity = {0, 0, -9.81};
        world.build();
        const double dt = 5e-6;
        for (int step = 0; step < 60000; ++step) {
            world.step(dt);
            EXPECT_LE(world.report.contact_count, 1);
        }
        return std::array{world.state.position[1], world.state.velocity[1]};
    };
    const auto surface = cross_floor(true), plane = cross_floor(false);
    EXPECT_NEAR(norm(surface[0] - plane[0]), 0, 1e-6);
    EXPECT_NEAR(norm(surface[1] - plane[1]), 0, 1e-5);
}

/// A ball without friction slides along x over ten boxes of 0.2 m.
std::array<Vec3, 2> slide_over_boxes(double gap, double step, double end = 0.5) {
    SphereWorld world;
    const MaterialId grain = world.add_material({.youngs_modulus = 1e7, .restitution = 0.3});
    const ShapeId box = world.shapes.add_convex(geometry::cube(0.2));
    for (int i = 0; i < 10; ++i) {
        world.add_wall(grain, box, {{(0.2 + gap) * i, 0.03, -0.1 + (i % 2 == 1 ? step : 0)}, {}});
    }
    world.add_sphere(grain, 0.05, 1.3, {{{-0.05, 0, 0.05}, {}}, {3, 0, 0}, {}});
    world.gravity = {0, 0, -9.81};
    world.build();
    const double dt = 0.5 * world.step_limit();
    while (world.time < end) {
        world.step(dt);
    }
    return {world.state.position.back(), world.state.velocity.back()};
}

TEST(SphereWalls, ASphereSlidesOverTheSeamsOfTenBoxesAsOverAPlane) {
    EXPECT_NEAR(slide_over_boxes(0, 0)[1].x, 3, 1e-6);
    EXPECT_NEAR(slide_over_boxes(1e-3, 0)[1].x, 3, 5e-3 * 3);
    EXPECT_NEAR(slide_over_boxes(-2e-5, 2e-5)[1].x, 3, 5e-3 * 3);
}

/// Contacts of a ball of 0.05 m that is in by 0.2 mm at the joint of two boxes.
std::int64_t contacts_at_joint(double gap, double step, double x) {
    SphereWorld world;
    const MaterialId grain = world.add_material({.youngs_modulus = 1e7, .restitution = 0.3});
    const ShapeId box = world.shapes.add_convex(geometry::cube(0.2));
    world.add_wall(grain, box, {{-0.1 - 0.5 * gap, 0.03, -0.1}, {}});
    world.add_wall(grain, box, {{0.1 + 0.5 * gap, 0.03, -0.1 + step}, {}});
    world.add_sphere(grain, 0.05, 1.3, {{{x, 0, 0.0498}, {}}, {}, {}});
    world.build();
    world.step(1e-7);
    return world.report.contact_count;
}

TEST(SphereWalls, AnEdgeIsHiddenUpToAStepAndAJointOfTheRadius) {
    EXPECT_EQ(contacts_at_joint(0, 0.7e-3 * 0.05, -1e-4), 1);
    EXPECT_EQ(contacts_at_joint(0, 1.4e-3 * 0.05, -1e-4), 2);
    EXPECT_EQ(contacts_at_joint(0.04 * 0.05, 0, 1e-5), 1);
    EXPECT_EQ(contacts_at_joint(0.07 * 0.05, 0, 1e-5), 2);
}

TEST(SphereWalls, ASphereIsHeldUpByAStepAndByAGapOfItsRadius) {
    EXPECT_LT(slide_over_boxes(0, 5e-3, 0.1)[1].x, 2.9);
    EXPECT_LT(slide_over_boxes(0.05, 0, 0.2)[1].x, 2.9);
}

TEST(SphereWalls, ASphereInAValleyOfTrianglesTouchesBothSidesAndOnARidgeOne) {
    for (const double side : {1.0, -1.0}) {
        SphereWorld world;
        const MaterialId grain = world.add_material({.youngs_modulus = 1e8, .restitution = 0.3});
        world.add_surface(grain, {{0, -1, 0}, {0, 1, 0}, {1, -1, side}, {1, 1, side}, {-1, -1, side}, {-1, 1, side}},
                          {0, 2, 3, 0, 3, 1, 0, 1, 5, 0, 5, 4});
        const double height = side > 0 ? 0.02 * std::sqrt(2.0) : 0.02;
        world.add_sphere(grain, 0.02, 0.05, {{{0, 0.1, height}, {}}, {}, {}});
        world.gravity = {0, 0, -9.81};
        world.build();
        for (int step = 0; step < 1000; ++step) {
            world.step(5e-6);
        }
        EXPECT_EQ(world.report.contact_count, side > 0 ? 2 : 1);
        EXPECT_NEAR(world.state.position[1].z, height, 1e-4);
    }
}

TEST(SphereWalls, AStackCarriesItsWeight) {
    SphereWorld world;
    const MaterialId grain = world.add_material({.youngs_modulus = 1e7, .restitution = 0.2, .static_friction = 0.3});
    world.add_plane(grain, {0, 0, 1}, {});
    for (int k = 0; k < 5; ++k) {
        world.add_sphere(grain, 0.01, 0.02, {{{0, 0, 0.01 + 0.02 * k}, {}}, {}, {}});
    }
    world.gravity = {0, 0, -9.81};
    world.build();
    const double dt = world.step_limit();
    Vec3 reaction{};
    int count = 0;
    while (world.time < 0.5) {
        world.step(dt);
        if (world.time > 0.4) {
            reaction += world.scratch.loads.force[0];
            ++count;
        }
    }
    EXPECT_NEAR(reaction.z / count, -5 * 0.02 * 9.81, 1e-3 * 0.981);
    for (std::size_t k = 1; k <= 5; ++k) {
        EXPECT_NEAR(world.state.position[k].x, 0, 1e-6);
        EXPECT_LT(norm(world.state.velocity[k]), 1e-4);
    }
}

TEST(SphereStep, TheLimitIsAShareOfTheShortestImpact) {
    SphereWorld world;
    const MaterialId grain = world.add_material({.youngs_modulus = 5e6, .poisson_ratio = 0.3});
    world.add_sphere(grain, 0.005, 2500 * 4.0 / 3 * M_PI * 1.25e-7, {{{}, {}}, {0.5, 0, 0}, {}});
    world.build();
    // Against a like sphere: m* = m/2, R* = R/2, E* = E/(2 (1 - nu^2)), v = 1 m/s.
    const double m = 0.5 * 1.308997e-3, e = 5e6 / 1.82;
    EXPECT_NEAR(world.step_limit(), 2.8683 / 50 * std::pow(m * m / (0.0025 * e * e), 0.2), 1e-3 * world.step_limit());
}

}  // namespace
}  // namespace riprap::solid::sphere_dem
