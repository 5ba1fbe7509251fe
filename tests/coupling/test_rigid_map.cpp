// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "coupling/tank_scenes.hpp"
#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"

namespace riprap::coupling {
namespace {

/// Two blocks that fly and spin, with samples.
struct Flying {
    test::Scene scene;
    SampleSet samples;
    body::Motion motion;
    fluid::BoundaryParticles particles;

    Flying() {
        scene.add(geometry::box({0.3, 0.5, 0.4}), {{1, 2, 3}, from_rotation_vector({0.1, 0.7, -0.4})});
        scene.add(geometry::cube(0.3), {{-1, 0, 0.5}, from_rotation_vector({-0.8, 0.1, 0.2})});
        SampleSettings settings;
        settings.spacing = 0.1;
        settings.reach = 0.3;
        settings.domain = {{-9, -9, -9}, {9, 9, 9}, {}, 3};
        settings.limit = 100'000;
        samples = sample_shapes(scene.shapes, scene.bodies, scene.state, settings);
        for (std::size_t b = 0; b < 2; ++b) {
            motion.pose.push_back({scene.state.position[b], scene.state.orientation[b]});
        }
        motion.velocity = {{0.3, -1.2, 0.5}, {0, 2, 1}};
        motion.angular_velocity = {{2, -3, 5}, {0.4, 0.1, -7}};
        motion.acceleration = {{-1, 0.2, 9}, {3, 3, 3}};
        motion.angular_acceleration = {{0.7, 11, -2}, {5, -5, 1}};
        place_samples(samples, motion, particles);
    }
};

TEST(RigidMap, the_power_of_loads_on_samples_is_that_of_force_and_torque) {
    Flying f;
    double power = 0;
    for (std::size_t i = 0; i < f.particles.position.size(); ++i) {
        const auto s = static_cast<double>(i);
        f.particles.pressure_force.push_back({std::sin(s), std::cos(3 * s), std::sin(7 * s + 1)});
        f.particles.viscous_force.push_back({std::cos(s), std::sin(5 * s), 0.3});
        power += dot(f.particles.pressure_force[i], f.particles.velocity[i]) +
                 dot(f.particles.viscous_force[i], f.particles.foot_velocity[i]);
    }
    FluidLoads loads;
    gather_loads(f.samples, f.motion, f.particles, loads);
    double rigid = 0, scale = 0;
    for (std::size_t b = 0; b < 2; ++b) {
        const Vec3 force = loads.pressure.force[b] + loads.viscous.force[b];
        const Vec3 torque = loads.pressure.torque[b] + loads.viscous.torque[b];
        rigid += dot(force, f.motion.velocity[b]) + dot(torque, f.motion.angular_velocity[b]);
        scale += norm(force) * norm(f.motion.velocity[b]) + norm(torque) * norm(f.motion.angular_velocity[b]);
    }
    EXPECT_NEAR(power, rigid, 1e-12 * scale);
}

TEST(RigidMap, the_power_on_bodies_that_deform_is_that_of_force_torque_and_pull) {
    Flying f;
    f.motion.stretch = {{1.1, 0.9, 1.0, 0.05, -0.02, 0.03}, {0.8, 1.2, 1.1, 0.0, 0.1, -0.05}};
    f.motion.stretch_rate = {{0.3, -0.7, 0.2, 0.4, -0.1, 0.6}, {-0.5, 0.1, 0.9, 0.2, 0.3, -0.4}};
    place_samples(f.samples, f.motion, f.particles);
    double power = 0, scale = 0;
    for (std::size_t i = 0; i < f.particles.position.size(); ++i) {
        const auto s = static_cast<double>(i);
        f.particles.pressure_force.push_back({std::sin(s), std::cos(3 * s), std::sin(7 * s + 1)});
        f.particles.viscous_force.push_back({std::cos(s), std::sin(5 * s), 0.3});
        power += dot(f.particles.pressure_force[i], f.particles.velocity[i]) +
                 dot(f.particles.viscous_force[i], f.particles.foot_velocity[i]);
        scale += norm(f.particles.pressure_force[i]) * norm(f.particles.velocity[i]);
    }
    FluidLoads loads;
    gather_loads(f.samples, f.motion, f.particles, loads);
    double affine = 0;
    for (std::size_t b = 0; b < 2; ++b) {
        for (const body::Loads* const of : {&loads.pressure, &loads.viscous}) {
            affine += dot(of->force[b], f.motion.velocity[b]) + dot(of->torque[b], f.motion.angular_velocity[b]) +
                      contract(of->pull[b], f.motion.stretch_rate[b]);
        }
    }
    EXPECT_NEAR(power, affine, 1e-13 * scale);
}

// The face of a body that turns goes faster than what is below it, and water sticks to the face.
TEST(RigidMap, water_sticks_to_the_face_before_a_sample_and_pulls_there) {
    test::Scene scene;
    scene.add(geometry::box({1, 0.6, 0.8}), {{1, 2, 3}, {}});
    SampleSettings settings;
    settings.spacing = 0.05;
    settings.reach = 0.15;
    settings.domain = {{-9, -9, -9}, {9, 9, 9}, {}, 3};
    settings.limit = 100'000;
    const SampleSet samples = sample_shapes(scene.shapes, scene.bodies, scene.state, settings);
    body::Motion motion;
    motion.pose = {{scene.state.position[0], scene.state.orientation[0]}};
    motion.velocity = motion.acceleration = motion.angular_acceleration = {{}};
    motion.angular_velocity = {{0, 0, 3}};
    fluid::BoundaryParticles particles;
    place_samples(samples, motion, particles);
    double deepest = 0, torque = 0;
    for (std::size_t i = 0; i < particles.position.size(); ++i) {
        const Vec3 arm = particles.position[i] - motion.pose[0].position, v = particles.foot_velocity[i];
        const Vec3 foot{v.y / 3, -v.x / 3, arm.z + samples.depth[i] * samples.normal[i].z};
        EXPECT_NEAR(std::max({std::abs(foot.x) / 0.5, std::abs(foot.y) / 0.3, std::abs(foot.z) / 0.4}), 1, 1e-6);
        EXPECT_NEAR(norm(foot - arm), samples.depth[i], 1e-6);
        deepest = std::max(deepest, norm(foot - arm));
        particles.pressure_force.push_back({});
        particles.viscous_force.push_back({-arm.y, arm.x, 0});
        torque += cross(foot, particles.viscous_force[i]).z;
    }
    EXPECT_GT(deepest, 2 * settings.spacing);
    FluidLoads loads;
    gather_loads(samples, motion, particles, loads);
    EXPECT_NEAR(loads.viscous.torque[0].z, torque, 1e-9 * torque);
    const std::vector<std::uint8_t> slips{1};
    settings.is_slippery = slips;
    const SampleSet slippery = sample_shapes(scene.shapes, scene.bodies, scene.state, settings);
    fluid::BoundaryParticles smooth;
    place_samples(slippery, motion, smooth);
    EXPECT_TRUE(smooth.foot_velocity.empty());
}

TEST(RigidMap, velocity_and_acceleration_are_the_time_derivatives_of_the_place) {
    Flying f;
    const double dt = 1e-4;
    const auto moved = [&](double t) {
        body::Motion motion = f.motion;
        for (std::size_t b = 0; b < 2; ++b) {
            const Vec3 omega = f.motion.angular_velocity[b], alpha = f.motion.angular_acceleration[b];
            motion.pose[b].position += t * f.motion.velocity[b] + 0.5 * t * t * f.motion.acceleration[b];
            // Exact to second order in t: exp(omega t + alpha t^2/2).
            motion.pose[b].orientation =
                from_rotation_vector(t * omega + 0.5 * t * t * alpha) * f.motion.pose[b].orientation;
        }
        fluid::BoundaryParticles particles;
        place_samples(f.samples, motion, particles);
        return particles.position;
    };
    const auto before = moved(-dt), after = moved(dt);
    for (std::size_t i = 0; i < before.size(); i += 7) {
        const Vec3 velocity = (after[i] - before[i]) / (2 * dt);
        const Vec3 acceleration = (after[i] - 2.0 * f.particles.position[i] + before[i]) / (dt * dt);
        EXPECT_NEAR(norm(velocity - f.particles.velocity[i]), 0, 1e-5);
        EXPECT_NEAR(norm(acceleration - f.particles.acceleration[i]), 0, 1e-4);
    }
}

/// Every third sample as a set of its own.
SampleSet every_third(const SampleSet& from, std::vector<std::int32_t>& numbers) {
    SampleSet some;
    for (std::size_t i = 1; i < from.body.size(); i += 3) {
        numbers.push_back(static_cast<std::int32_t>(i));
        some.body.push_back(from.body[i]);
        some.anchor.push_back(from.anchor[i]);
        some.normal.push_back(from.normal[i]);
        some.depth.push_back(from.depth[i]);
        some.volume.push_back(from.volume[i]);
        some.is_slippery.push_back(from.is_slippery[i]);
    }
    return some;
}

TEST(RigidMap, a_view_of_some_samples_is_placed_and_gathered_as_a_set_of_them_is) {
    Flying f;
    f.samples.is_slippery.set(4, 1);
    std::vector<std::int32_t> numbers;
    const SampleSet copied = every_third(f.samples, numbers);
    const SampleView view(f.samples, numbers);
    fluid::BoundaryParticles of_copy, of_view;
    place_samples(copied, f.motion, of_copy);
    place_samples(view, f.motion, of_view);
    EXPECT_EQ(of_view.position, of_copy.position);
    EXPECT_EQ(of_view.velocity, of_copy.velocity);
    EXPECT_EQ(of_view.acceleration, of_copy.acceleration);
    EXPECT_EQ(of_view.volume, of_copy.volume);
    EXPECT_EQ(of_view.is_slippery, of_copy.is_slippery);
    EXPECT_EQ(of_view.is_slippery[1], 1);
    std::vector<Vec3> push;
    body::Loads loads, loads_of_copy;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        push.push_back({std::sin(static_cast<double>(i)), 1, std::cos(static_cast<double>(i))});
    }
    gather(view, f.motion, of_view.position, push, loads);
    gather(copied, f.motion, of_copy.position, push, loads_of_copy);
    EXPECT_EQ(loads.force, loads_of_copy.force);
    EXPECT_EQ(loads.torque, loads_of_copy.torque);
}

/// Pieces of a sum go by the numbers of samples: which others are near water changes no bit of it.
TEST(RigidMap, loads_of_a_large_body_do_not_depend_on_which_samples_are_left_out) {
    test::Scene scene;
    scene.add(geometry::cube(0.1), {{3, 0, 0}, {}});
    scene.add(geometry::box({2.1, 1.5, 1.2}), {{1, 2, 3}, from_rotation_vector({0.1, 0.7, -0.4})});
    scene.add(geometry::cube(0.3), {{-1, 0, 0.5}, {}});
    SampleSettings settings;
    settings.spacing = 0.05;
    settings.reach = 0.15;
    settings.domain = {{-9, -9, -9}, {9, 9, 9}, {}, 3};
    settings.limit = 100'000;
    const SampleSet samples = sample_shapes(scene.shapes, scene.bodies, scene.state, settings);
    ASSERT_GT(samples.size(), 3 * 4096);
    body::Motion motion;
    for (std::size_t b = 0; b < 3; ++b) {
        motion.pose.push_back({scene.state.position[b], scene.state.orientation[b]});
    }
    motion.velocity = motion.angular_velocity = motion.acceleration = motion.angular_acceleration =
        std::vector<Vec3>(3);
    fluid::BoundaryParticles all;
    place_samples(samples, motion, all);
    std::mt19937_64 random(3);
    std::vector<std::int32_t> near;
    std::vector<Vec3> force, force_near, place_near;
    for (std::int32_t s = 0; s < samples.size(); ++s) {
        const auto i = static_cast<std::size_t>(s);
        const bool is_near = random() % 3 != 0 && (s < 5000 || s > 9000);
        force.push_back(is_near ? Vec3{std::sin(1.0 * s), std::cos(3.0 * s), std::exp(std::sin(7.0 * s))} : Vec3{});
        if (is_near) {
            near.push_back(s);
            force_near.push_back(force[i]);
            place_near.push_back(all.position[i]);
        }
    }
    body::Loads whole, part;
    gather(samples, motion, all.position, force, whole);
    gather(SampleView(samples, near), motion, place_near, force_near, part);
    for (std::size_t b = 0; b < 3; ++b) {
        EXPECT_EQ(whole.force[b], part.force[b]) << b;
        EXPECT_EQ(whole.torque[b], part.torque[b]) << b;
        EXPECT_GT(norm(part.force[b]), 0) << b;
    }
}

}  // namespace
}  // namespace riprap::coupling
