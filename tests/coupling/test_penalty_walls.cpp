// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "coupling/tank_scenes.hpp"
#include "riprap/coupling/particle_walls/penalty_walls.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::coupling {
namespace {

constexpr double dp = 0.05;

struct Push {
    Vec3 force;   ///< on the particle
    Vec3 load;    ///< on the body
    Vec3 torque;  ///< likewise
};

/// One particle beside a box of 0.2 m (or as wide as `width`) in a planar domain 1 m long that repeats along x.
Push push_of(const Vec3& box_place, const Vec3& x, const Vec3& velocity = {}, double width = 0.2,
             bool is_periodic = true) {
    test::Scene scene;
    scene.bodies.is_planar = true;
    const std::vector<geometry::Point2> corners{
        {-0.5 * width, -0.1}, {0.5 * width, -0.1}, {0.5 * width, 0.1}, {-0.5 * width, 0.1}};
    scene.add(geometry::planar_prism(corners).value(), {box_place, {}});
    fluid::SphSettings settings;
    settings.spacing = dp;
    settings.particle_mass = settings.rest_density * dp * dp;
    settings.sound_speed = 30;
    settings.domain = {{0, 0, 0}, {1, 1, 0}, {is_periodic, false, false}, 2};
    fluid::ParticleState particles;
    particles.add(x, velocity, settings.rest_density, 0);
    body::Motion motion;
    motion.pose = {{box_place, {}}};
    motion.velocity = motion.angular_velocity = motion.acceleration = motion.angular_acceleration = {Vec3{}};
    fluid::SparseVectors force;
    FluidLoads loads;
    PenaltyWalls walls;
    walls.push(scene.shapes, scene.bodies, motion, {}, penalty_settings(settings, 0), {}, particles, force, loads);
    return {force[0], loads.pressure.force[0], loads.pressure.torque[0]};
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
    EXPECT_LE(norm(a - b), tolerance) << a.x << ' ' << b.x;
}

TEST(PenaltyWalls, a_face_that_reaches_across_a_periodic_side_pushes_there_as_anywhere) {
    const Vec3 closing{-0.2, 0.1, 0};
    const Push middle = push_of({0.5, 0.5, 0}, {0.605, 0.53, 0}, closing);
    ASSERT_GT(middle.force.x, 0);
    for (const double shift : {0.5, -0.5, 2.5}) {  // the body may have gone round more than once
        const Push across = push_of({0.5 + shift, 0.5, 0}, {0.105, 0.53, 0}, closing);
        expect_near(across.force, middle.force, 1e-9 * norm(middle.force));
        expect_near(across.load, -1.0 * middle.force, 1e-9 * norm(middle.force));
        expect_near(across.torque, middle.torque, 1e-9 * norm(middle.torque));
    }
    EXPECT_EQ(norm(push_of({1.0, 0.5, 0}, {0.105, 0.53, 0}, closing, 0.2, false).force), 0);
}

TEST(PenaltyWalls, a_bed_as_long_as_the_period_has_no_edge) {
    const Push middle = push_of({0.5, 0.5, 0}, {0.5, 0.615, 0}, {}, 1);
    ASSERT_GT(middle.force.y, 0);
    for (const double x : {0.0, 0.002, 0.998, 1.0}) {
        expect_near(push_of({0.5, 0.5, 0}, {x, 0.615, 0}, {}, 1).force, middle.force, 1e-9 * norm(middle.force));
    }
}

/// Pushes on a particle `above` the lower of two plates with a gap between them, and loads on both.
struct Squeeze {
    Vec3 force, on_lower, on_upper;
};

Squeeze squeeze(double gap, double above) {
    test::Scene scene;
    scene.bodies.is_planar = true;
    const std::vector<geometry::Point2> corners{{-0.5, -0.1}, {0.5, -0.1}, {0.5, 0.1}, {-0.5, 0.1}};
    body::Motion motion;
    for (const double y : {-0.1, gap + 0.1}) {
        motion.pose.push_back({{0, y, 0}, {}});
        scene.add(geometry::planar_prism(corners).value(), motion.pose.back());
    }
    motion.velocity = motion.angular_velocity = motion.acceleration = motion.angular_acceleration = {Vec3{}, Vec3{}};
    fluid::SphSettings settings;
    settings.spacing = dp;
    settings.particle_mass = settings.rest_density * dp * dp;
    settings.sound_speed = 30;
    settings.domain = {{-1, -1, 0}, {1, 1, 0}, {}, 2};
    fluid::ParticleState particles;
    particles.add({0, above, 0}, {}, settings.rest_density, 0);
    fluid::SparseVectors force;
    FluidLoads loads;
    PenaltyWalls().push(scene.shapes, scene.bodies, motion, {},
                        guard_settings(settings, 0.1 * dp / settings.sound_speed), {}, particles, force, loads);
    return {force[0], loads.pressure.force[0], loads.pressure.force[1]};
}

TEST(PenaltyWalls, a_particle_between_two_faces_is_kept_in_the_middle_and_holds_neither_up) {
    const double stiffness = 0.5 * 1000 * 30 * 30;  // guard_settings
    for (const double gap : {0.3 * dp, 0.1 * dp, 0.0, -0.01 * dp}) {
        const Squeeze middle = squeeze(gap, 0.5 * gap);
        EXPECT_LT(norm(middle.on_lower) + norm(middle.on_upper), 1e-9 * stiffness * dp) << gap;
        const Squeeze low = squeeze(gap, 0.5 * gap - 0.02 * dp);
        expect_near(low.force, {0, stiffness * 0.02 * dp, 0}, 1e-6 * stiffness * dp);
        expect_near(low.on_lower, -1.0 * low.force, 1e-9 * stiffness * dp);
        EXPECT_EQ(norm(low.on_upper), 0);
    }
    // Where the other face is too far away to matter it is pushed from a fifth of a spacing on.
    EXPECT_NEAR(squeeze(0.5 * dp, 0.15 * dp).force.y, stiffness * 0.05 * dp, 1e-6 * stiffness * dp);
}

/// Particles counted as gone through a convex polygon when one at `x` has come from `from` within a step of 1 ms.
std::int64_t passages(const std::vector<geometry::Point2>& corners, const Vec3& from, const Vec3& x,
                      const Vec3& speed_of_body = {}) {
    test::Scene scene;
    scene.bodies.is_planar = true;
    scene.add(geometry::planar_prism(corners).value(), {});
    fluid::SphSettings settings;
    settings.spacing = dp;
    settings.particle_mass = settings.rest_density * dp * dp;
    settings.sound_speed = 30;
    settings.domain = {{-1, -1, 0}, {1, 1, 0}, {}, 2};
    fluid::ParticleState particles;
    particles.add(x, 1000.0 * (x - from), settings.rest_density, 0);
    body::Motion motion;
    motion.pose = {{}};
    motion.velocity = {speed_of_body};
    motion.angular_velocity = motion.acceleration = motion.angular_acceleration = {Vec3{}};
    fluid::SparseVectors force;
    FluidLoads loads;
    PenaltyWalls walls;
    walls.push(scene.shapes, scene.bodies, motion, {}, guard_settings(settings, 1e-3), {}, particles, force, loads);
    return walls.passages().count;
}

TEST(PenaltyWalls, a_particle_that_goes_through_a_thin_plate_is_counted_in_the_step_that_takes_it_past_the_middle) {
    const std::vector<geometry::Point2> plate{{-0.5, -0.004}, {0.5, -0.004}, {0.5, 0.004}, {-0.5, 0.004}};
    EXPECT_EQ(passages(plate, {0, 0.006, 0}, {0, 0.002, 0}), 0);    // in, and not past the middle
    EXPECT_EQ(passages(plate, {0, 0.002, 0}, {0, -0.002, 0}), 1);   // past it
    EXPECT_EQ(passages(plate, {0, -0.002, 0}, {0, -0.006, 0}), 0);  // out on the other side
    EXPECT_EQ(passages(plate, {0, 0.006, 0}, {0, -0.007, 0}), 1);   // all at once
    EXPECT_EQ(passages(plate, {0, 0.012, 0}, {0, 0.006, 0}), 0);
    // The plate comes to the particle.
    EXPECT_EQ(passages(plate, {0, -0.006, 0}, {0, -0.006, 0}, {0, 13, 0}), 1);
}

TEST(PenaltyWalls, a_particle_that_goes_around_an_edge_or_a_tip_has_gone_through_nothing) {
    const std::vector<geometry::Point2> plate{{-0.5, -0.004}, {0.5, -0.004}, {0.5, 0.004}, {-0.5, 0.004}};
    EXPECT_EQ(passages(plate, {0.502, 0.006, 0}, {0.502, -0.006, 0}), 0);
    const std::vector<geometry::Point2> knife{{-0.2, -0.05}, {0.4, 0}, {-0.2, 0.05}};  // centroid at 0
    EXPECT_EQ(passages(knife, {0.399, 0.003, 0}, {0.399, -0.003, 0}), 0);
    EXPECT_EQ(passages(knife, {0.385, 0.005, 0}, {0.385, -0.005, 0}), 0);
    EXPECT_EQ(passages(knife, {0.36, 0.005, 0}, {0.36, -0.005, 0}), 1);
}

/// Loads are summed per body and block of particles, and blocks in order: what a block brings is the same whoever has
/// the others, and ghosts bring nothing.
TEST(PenaltyWalls, loads_are_sums_of_those_of_blocks_of_particles_without_ghosts) {
    test::Scene scene;
    scene.bodies.is_planar = true;
    for (const double x : {0.3, 0.75}) {
        const std::vector<geometry::Point2> corners{{-0.2, -0.1}, {0.2, -0.1}, {0.2, 0.1}, {-0.2, 0.1}};
        scene.add(geometry::planar_prism(corners).value(), {{x, 0.5, 0}, {}});
    }
    fluid::SphSettings settings;
    settings.spacing = dp;
    settings.particle_mass = settings.rest_density * dp * dp;
    settings.sound_speed = 30;
    settings.domain = {{0, 0, 0}, {1, 1, 0}, {}, 2};
    body::Motion motion;
    motion.pose = {{{0.3, 0.5, 0}, {}}, {{0.75, 0.5, 0}, {}}};
    motion.velocity = motion.angular_velocity = motion.acceleration = motion.angular_acceleration =
        std::vector<Vec3>(2);
    fluid::ParticleState particles;
    const std::int64_t count = 2 * parallel::reduce_block + 500;
    for (std::int64_t i = 0; i < count; ++i) {
        const auto s = static_cast<double>(i);
        particles.add({0.1 + 0.8 * s / static_cast<double>(count), 0.61 + 0.004 * std::sin(s), 0}, {0, std::cos(s), 0},
                      settings.rest_density, static_cast<std::int32_t>(i));
    }
    const auto loads_of = [&](const fluid::ParticleState& water) {
        fluid::SparseVectors force;
        FluidLoads loads;
        PenaltyWalls walls;
        walls.push(scene.shapes, scene.bodies, motion, {}, penalty_settings(settings, 1e-4), {}, water, force, loads);
        return loads.pressure;
    };
    const body::Loads whole = loads_of(particles);
    Vec3 force[2], torque[2];
    for (std::int64_t own = 0; own < 3; ++own) {  // three holders of one block each, all others their ghosts
        particles.held = {};
        particles.held.whole = 3;
        for (std::int64_t k = 0; k < 3; ++k) {
            particles.held.add(k, k == own, std::min(parallel::reduce_block, count - k * parallel::reduce_block));
        }
        const body::Loads part = loads_of(particles);
        for (std::size_t b = 0; b < 2; ++b) {
            force[b] += part.force[b];
            torque[b] += part.torque[b];
        }
    }
    for (std::size_t b = 0; b < 2; ++b) {
        EXPECT_EQ(force[b], whole.force[b]);
        EXPECT_EQ(torque[b], whole.torque[b]);
        EXPECT_NE(whole.force[b].y, 0);
    }
}

}  // namespace
}  // namespace riprap::coupling
