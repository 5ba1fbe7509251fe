// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/face_gauge.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/tank_scenes.hpp"
#include "riprap/coupling/sample_shapes.hpp"

namespace riprap::coupling {
namespace {

constexpr double dp = 0.1;

/// Bodies with boundary particles that carry forces of any kind.
struct Loaded {
    test::Scene scene;
    SampleSet samples;
    BodyMotion motion;
    fluid::BoundaryParticles particles;
    fluid::Domain domain{{-3, -3, -3}, {3, 3, 3}, {}, 3};

    explicit Loaded(int dimension) {
        domain.dimension = dimension;
        scene.bodies.is_planar = dimension == 2;
    }
    void sample() {
        SampleSettings settings;
        settings.spacing = dp;
        settings.reach = 3 * dp;
        settings.domain = domain;
        settings.limit = 100'000;
        samples = sample_shapes(scene.shapes, scene.bodies, scene.state, settings);
        const auto count = static_cast<std::size_t>(scene.bodies.size());
        motion.velocity = motion.angular_velocity = motion.acceleration = motion.angular_acceleration =
            std::vector<Vec3>(count);
        place();
        for (std::size_t i = 0; i < particles.position.size(); ++i) {
            const auto s = static_cast<double>(i);
            particles.pressure_force.push_back({1 + std::sin(s), std::cos(3 * s), std::sin(7 * s + 1)});
        }
    }
    void place() {
        motion.pose.clear();
        for (std::size_t b = 0; b < scene.state.position.size(); ++b) {
            motion.pose.push_back({scene.state.position[b], scene.state.orientation[b]});
        }
        place_samples(samples, motion, particles);
    }
    FaceGauge at(const Vec3& place) const {
        return find_face(scene.shapes, scene.bodies, scene.state, {}, place, dp).value();
    }
    double read(const FaceGauge& gauge) const {
        return read_face(gauge, {scene.shapes, scene.bodies, motion, samples, particles, domain, dp, 3 * dp, {}});
    }
    double read(const Vec3& place) const { return read(at(place)); }
    /// The force against +x on boundary particles at places that `is_part` picks [N].
    template <class Pick>
    double force(Pick is_part) const {
        double sum = 0;
        for (std::size_t i = 0; i < particles.position.size(); ++i) {
            sum -= is_part(particles.position[i]) ? particles.pressure_force[i].x : 0.0;
        }
        return sum;
    }
};

/// A square with its right-hand side at x = 0.8, in 2D; samples within a spacing and the reach of it belong to that
/// face.
Loaded square() {
    Loaded f(2);
    f.scene.add(geometry::box({1.6, 1, 1}), {});
    f.sample();
    return f;
}

TEST(FaceGauge, readings_along_a_whole_face_add_up_to_the_force_on_it) {
    const Loaded f = square();
    constexpr int count = 400;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        sum += f.read(Vec3{0.8, -0.5 + (i + 0.5) / count, 0}) / count;
    }
    const double force = f.force([](const Vec3& x) { return x.x > 0.8 - 4 * dp; });
    ASSERT_GT(std::abs(force), 10);
    EXPECT_NEAR(sum, force, 1e-4 * std::abs(force));
}

TEST(FaceGauge, readings_all_over_a_face_of_a_cube_add_up_to_the_force_on_it) {
    Loaded f(3);
    f.scene.add(geometry::cube(1), {});
    f.sample();
    constexpr int count = 40;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            sum += f.read(Vec3{0.5, -0.5 + (i + 0.5) / count, -0.5 + (j + 0.5) / count}) / (count * count);
        }
    }
    const double force = f.force([](const Vec3& x) { return x.x > 0.5 - 4 * dp; });
    EXPECT_NEAR(sum, force, 2e-3 * std::abs(force));
}

TEST(FaceGauge, in_the_corner_of_a_tank_the_particles_beyond_the_floor_belong_to_the_wall) {
    Loaded f(2);
    f.scene.add_half_space({0, 1, 0}, 0);
    f.scene.add_half_space({-1, 0, 0}, 0);
    f.sample();
    const std::size_t corner = f.particles.position.size();
    f.particles.pressure_force.assign(corner, {});
    int pressed = 0;
    for (std::size_t i = 0; i < corner; ++i) {
        const Vec3& x = f.particles.position[i];
        if (x.x > 0 && x.y < 0 && x.y > -dp && x.x < dp) {
            f.particles.pressure_force[i] = {100, 0, 0};
            ++pressed;
        }
    }
    ASSERT_GT(pressed, 0);
    double sum = 0;
    for (int i = 0; i < 300; ++i) {
        sum += 0.001 * f.read(Vec3{0, 0.0005 + 0.001 * i, 0});
    }
    EXPECT_NEAR(sum, 100 * pressed, 0.01 * 100 * pressed);
    const double foot = f.read(FaceGauge{BodyId{1}, {0, 0, 0}, {-1, 0, 0}});  // in the corner itself
    ASSERT_GT(foot, 0);
    EXPECT_NEAR(f.read(Vec3{0, 1e-3 * dp, 0}), foot, 0.01 * foot);
}

TEST(FaceGauge, two_blocks_that_lie_flush_read_as_one) {
    Loaded one(2), two(2);
    one.scene.add(geometry::box({1, 2, 1}), {});
    two.scene.add(geometry::box({1, 1, 1}), {{0, -0.5, 0}, {}});
    two.scene.add(geometry::box({1, 1, 1}), {{0, 0.5, 0}, {}});
    for (Loaded* f : {&one, &two}) {
        f->sample();
        for (std::size_t i = 0; i < f->particles.position.size();
             ++i) {  // 1 Pa on the first layer of the right-hand side
            f->particles.pressure_force[i] = {f->particles.position[i].x > 0.5 - dp ? -dp : 0, 0, 0};
        }
    }
    for (const double y : {-0.3, -0.1, 0.05, 0.2}) {
        EXPECT_NEAR(one.read(Vec3{0.5, y, 0}), 1, 1e-9);
        EXPECT_NEAR(two.read(Vec3{0.5, y, 0}), 1, 1e-9);
    }
}

TEST(FaceGauge, it_stays_with_its_body_and_reads_the_same_wherever_that_is_turned) {
    Loaded f = square();
    const FaceGauge gauge = f.at({0.8, 0.13, 0});
    const double before = f.read(gauge);
    ASSERT_GT(std::abs(before), 1);
    const Quat turn = from_rotation_vector({0, 0, 0.7});
    f.scene.state.position[0] = {0.4, -0.3, 0};
    f.scene.state.orientation[0] = turn;
    for (Vec3& force : f.particles.pressure_force) {
        force = rotate(turn, force);
    }
    f.place();
    EXPECT_NEAR(f.read(gauge), before, 1e-9 * std::abs(before));
}

TEST(FaceGauge, it_reads_nothing_while_a_block_lies_on_it) {
    Loaded f(2);
    f.scene.add(geometry::box({1.6, 1, 1}), {});
    f.scene.add(geometry::box({0.4, 0.4, 1}), {{1.0, 0, 0}, {}});
    f.sample();
    const FaceGauge covered = f.at({0.8, 0.05, 0});
    EXPECT_EQ(f.read(FaceGauge{BodyId{0}, covered.anchor, covered.normal}), 0);
    EXPECT_NE(f.read(Vec3{0.8, 0.45, 0}), 0);
}

TEST(FaceGauge, far_from_every_wet_face_there_is_none_to_stand_in) {
    const Loaded f = square();
    EXPECT_FALSE(find_face(f.scene.shapes, f.scene.bodies, f.scene.state, {}, {0.95, 0, 0}, dp));
    const std::vector<std::uint8_t> is_dry{1};
    EXPECT_FALSE(find_face(f.scene.shapes, f.scene.bodies, f.scene.state, is_dry, {0.8, 0, 0}, dp));
    const FaceGauge gauge = f.at({0.85, 0.2, 0});
    EXPECT_NEAR(gauge.anchor.x, 0.8, 1e-12);
    EXPECT_NEAR(gauge.normal.x, 1, 1e-12);
}

}  // namespace
}  // namespace riprap::coupling
