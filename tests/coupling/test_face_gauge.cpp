// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/face_reading.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/tank_scenes.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"

namespace riprap::coupling {
namespace {

constexpr double dp = 0.1;

/// Bodies with boundary particles that carry forces of any kind.
struct Loaded {
    test::Scene scene;
    SampleSet samples;
    body::Motion motion;
    fluid::BoundaryParticles particles;
    fluid::Domain domain{{-3, -3, -3}, {3, 3, 3}, {}, 3};
    std::vector<std::uint8_t> is_dry;

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
        return read_face(gauge,
                         {scene.shapes, scene.bodies, is_dry, motion, samples, particles, domain, dp, 3 * dp, {}});
    }
    double read(const Vec3& place) const { return read(at(place)); }
    /// 1 Pa to the left on the particles that `is_layer` picks: the first layer of some right-hand sides, in 2D.
    template <class Pick>
    void press(Pick is_layer) {
        for (std::size_t i = 0; i < particles.position.size(); ++i) {
            particles.pressure_force[i] = is_layer(particles.position[i]) ? Vec3{-dp, 0, 0} : Vec3{};
        }
    }
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

/// A square with its right-hand side at x = 0.8.
Loaded square() {
    Loaded f(2);
    f.scene.add(geometry::box({1.6, 1, 1}), {});
    f.sample();
    return f;
}

TEST(FaceGauge, readings_along_a_face_add_up_to_the_force_on_it) {
    for (const int dimension : {2, 3}) {
        Loaded f(dimension);
        f.scene.add(geometry::box({1, 1, 1}), {});
        f.sample();
        for (Vec3& force : f.particles.pressure_force) {
            force.x += 3;  // so that the force is not next to nothing
        }
        const int across = dimension == 3 ? 20 : 1, count = 20;
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            for (int j = 0; j < across; ++j) {
                const double z = dimension == 3 ? -0.5 + (j + 0.5) / across : 0.0;
                sum += f.read(Vec3{0.5, -0.5 + (i + 0.5) / count, z}) / (count * across);
            }
        }
        const double force = f.force([](const Vec3& x) { return x.x > 0.5 - 4 * dp; });
        EXPECT_NEAR(sum, force, 0.02 * std::abs(force)) << dimension;
    }
}

TEST(FaceGauge, an_even_pressure_is_read_the_same_to_the_edges_of_a_face_wherever_it_is_turned) {
    for (const double yaw : {0.0, 0.4, 0.785}) {
        Loaded f(3);
        const Quat turn = from_rotation_vector({0.3, -0.2, yaw});
        f.scene.add(geometry::cube(1), {{0.1, 0.2, -0.3}, turn});
        f.sample();
        const Vec3 n = rotate(turn, {0, 0, 1});
        f.particles.pressure_force.assign(f.particles.position.size(), {});
        for (std::size_t i = 0; i < f.particles.position.size(); ++i) {  // the layer under the top, its rim included
            const Vec3 local = to_body(f.motion.pose[0], f.particles.position[i]);
            f.particles.pressure_force[i] = local.z > 0.5 - 0.7 * dp ? -dp * dp * n : Vec3{};
        }
        for (const Vec3& place : {Vec3{0, 0, 0.5}, Vec3{0.4, 0.1, 0.5}, Vec3{0.49, 0.3, 0.5}, Vec3{0.49, -0.49, 0.5}}) {
            EXPECT_NEAR(f.read(to_world(f.motion.pose[0], place)), 1, 1e-9) << yaw;
        }
    }
}

// The spline is as wide as four even ones of a spacing, with a variance of dp^2/12 each; the sensor adds its own.
TEST(FaceGauge, a_sensor_reads_the_mean_over_its_square_of_a_pressure_that_is_curved) {
    for (const double side : {0.0, 0.07, 0.4}) {
        Loaded f(3);
        f.scene.add(geometry::cube(2), {});
        f.sample();
        for (std::size_t i = 0; i < f.particles.position.size(); ++i) {
            const Vec3& x = f.particles.position[i];
            const double p = 3 + x.y * x.y + 2 * x.x * x.x;
            f.particles.pressure_force[i] = x.z > 1 - 0.7 * dp ? Vec3{0, 0, -dp * dp * p} : Vec3{};
        }
        FaceGauge gauge = f.at({0.11, 0.03, 1});
        gauge.side = side;
        const double mean = 3 + 0.03 * 0.03 + 2 * 0.11 * 0.11 + 3 * (dp * dp / 3 + side * side / 12);
        EXPECT_NEAR(f.read(gauge), mean, 1e-9) << side;
    }
}

/// A force on the particles that lie under the floor and behind the plane x = 0 comes back at the foot of the wall.
void expect_corner_counts(Loaded& f) {
    f.sample();
    f.particles.pressure_force.assign(f.particles.position.size(), {});
    int pressed = 0;
    for (std::size_t i = 0; i < f.particles.position.size(); ++i) {
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
    EXPECT_NEAR(sum, 100 * pressed, 0.1 * 100 * pressed);
    const FaceGauge wall = f.at({0, 0.01, 0});
    const double foot =
        f.read(FaceGauge{wall.body, wall.anchor - Vec3{0, 0.01, 0}, wall.normal});  // in the corner itself
    ASSERT_GT(foot, 0);
    EXPECT_NEAR(f.read(Vec3{0, 1e-3 * dp, 0}), foot, 0.01 * foot);
}

TEST(FaceGauge, in_the_corner_of_a_tank_what_lies_beyond_the_floor_belongs_to_the_foot_of_the_wall) {
    Loaded tank(2), plate(2);
    tank.scene.add_half_space({0, 1, 0}, 0);
    tank.scene.add_half_space({-1, 0, 0}, 0);
    expect_corner_counts(tank);
    plate.scene.add_half_space({0, 1, 0}, 0);
    plate.scene.add(geometry::box({1, 2, 1}), {{0.5, 1, 0}, {}}, body::Drive::fixed);  // stands on the floor
    expect_corner_counts(plate);
}

TEST(FaceGauge, blocks_that_lie_flush_read_as_one_with_a_gap_between_them_or_without) {
    for (const double gap : {0.0, 0.02 * dp, 0.5 * dp}) {
        Loaded f(2);
        f.scene.add(geometry::box({1, 1, 1}), {{0, -0.5 - 0.5 * gap, 0}, {}});
        f.scene.add(geometry::box({1, 1, 1}), {{0, 0.5 + 0.5 * gap, 0}, {}});
        f.sample();
        f.press([](const Vec3& x) { return x.x > 0.5 - 0.7 * dp; });
        for (const double y : {-0.3, -0.1, -0.05, 0.07, 0.2}) {
            EXPECT_NEAR(f.read(Vec3{0.5, y, 0}), 1, 1e-9) << gap;
        }
    }
}

TEST(FaceGauge, blocks_beside_and_behind_add_nothing) {
    Loaded f(2);
    f.scene.add(geometry::box({1, 0.4, 1}), {});
    f.scene.add(geometry::box({1, 0.4, 1}), {{0, 0.8, 0}, {}});  // a row of pickets
    f.scene.add(geometry::box({1, 0.4, 1}), {{0, -0.8, 0}, {}});
    f.scene.add(geometry::box({0.4, 3, 1}), {{-0.75, 0, 0}, {}});  // a wall behind them
    f.sample();
    f.press([](const Vec3& x) { return x.x > 0.5 - 0.7 * dp || (x.x < -0.5 && x.x > -0.55 - 0.7 * dp); });
    EXPECT_NEAR(f.read(Vec3{0.5, 0.0, 0}), 1, 1e-9);
    EXPECT_NEAR(f.read(Vec3{0.5, 0.75, 0}), 1, 1e-9);
}

TEST(FaceGauge, the_force_on_a_slope_is_not_that_on_the_floor_before_it) {
    Loaded f(2);
    f.scene.add_half_space({0, 1, 0}, 0);
    f.scene.add_half_space({-0.1, 1, 0}, 0);  // rises 1 in 10 from x = 0
    f.sample();
    f.particles.pressure_force.assign(f.particles.position.size(), {});
    for (std::size_t i = 0; i < f.particles.position.size(); ++i) {
        f.particles.pressure_force[i] =
            f.samples.body[i].value == 1 && f.particles.position[i].y > 0 ? Vec3{0, -1, 0} : Vec3{};
    }
    EXPECT_NEAR(f.read(FaceGauge{BodyId{0}, {-dp, 0, 0}, {0, 1, 0}}), 0, 1e-9);
    EXPECT_GT(f.read(Vec3{0.5, 0.05, 0}), 1);
}

TEST(FaceGauge, what_is_dry_neither_covers_a_face_nor_goes_on_with_it) {
    Loaded f(2);
    f.scene.add(geometry::box({1, 1, 1}), {});
    f.scene.add(geometry::box({0.4, 3, 1}), {{0.7, 0, 0}, {}});
    f.sample();
    f.press([](const Vec3& x) { return x.x < 0.5 && x.x > 0.5 - 0.7 * dp; });
    const FaceGauge gauge{BodyId{0}, {0.5, 0.1, 0}, {1, 0, 0}};
    EXPECT_EQ(f.read(gauge), 0);
    f.is_dry = {0, 1};
    EXPECT_NEAR(f.read(gauge), 1, 1e-9);
}

TEST(FaceGauge, a_floor_goes_on_across_periodic_sides) {
    Loaded f(2);
    f.domain = {{0, -1, -1}, {1.2, 1, 1}, {true, false, false}, 2};
    f.scene.add(geometry::box({1.2, 1, 1}), {{0.6, -0.5, 0}, {}});
    f.sample();
    f.particles.pressure_force.assign(f.particles.position.size(), {});
    for (std::size_t i = 0; i < f.particles.position.size(); ++i) {
        f.particles.pressure_force[i] = {0, f.particles.position[i].y > -0.7 * dp ? -dp : 0, 0};
    }
    for (const double x : {0.6, 0.02, 0.0, 1.19}) {
        EXPECT_NEAR(f.read(FaceGauge{BodyId{0}, {x - 0.6, 0.5, 0}, {0, 1, 0}}), 1, 1e-9) << x;
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
    EXPECT_EQ(f.read(FaceGauge{BodyId{0}, {0.8, 0.05, 0}, {1, 0, 0}}), 0);
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
