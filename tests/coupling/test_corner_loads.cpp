// SPDX-License-Identifier: Apache-2.0
// Walls of tanks meet each other and the floor: each bears the pressure on its own face.
#include "riprap/coupling/samples/corner_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/tank_scenes.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"
#include "riprap/fluid/particle/kernel.hpp"

namespace riprap::coupling {
namespace {

constexpr double dp = 0.02, h = 1.5 * dp;
constexpr long cells = 8;  ///< of the water, a side
constexpr double side = cells * dp;
constexpr double rough = 0.03;  ///< of a load: sums over lattices beside integrals

/// Bodies that never move, and water that presses with 1 Pa on all that it meets, at rest on a lattice.
struct Tank {
    test::Scene scene;
    std::vector<Vec3> water;

    explicit Tank(bool is_planar) { scene.bodies.is_planar = is_planar; }
    bool is_planar() const { return scene.bodies.is_planar; }
    BodyId add_box(const Vec3& low, const Vec3& high) {
        const Vec3 size = high - low;
        const double z = is_planar() ? 0 : 0.5 * (low.z + high.z);
        return scene.add(geometry::box({size.x, size.y, is_planar() ? 1 : size.z}),
                         {{0.5 * (low.x + high.x), 0.5 * (low.y + high.y), z}, {}}, body::Drive::fixed);
    }
    /// Fills a cube that begins at a corner with water.
    void fill(const Vec3& corner) {
        for (long k = 0; k < (is_planar() ? 1 : cells); ++k) {
            for (long j = 0; j < cells; ++j) {
                for (long i = 0; i < cells; ++i) {
                    const auto place = [](long n) { return (static_cast<double>(n) + 0.5) * dp; };
                    water.push_back(corner + Vec3{place(i), place(j), is_planar() ? 0 : place(k)});
                }
            }
        }
    }
    /// Forces on the bodies, in pairs V V_w (p + p_w) grad W [N, or N/m].
    std::vector<Vec3> forces(bool hands_over = true) {
        const int dimension = is_planar() ? 2 : 3;
        SampleSettings settings;
        settings.spacing = dp;
        settings.reach = 2 * h;
        settings.domain = {{-0.3, -0.3, is_planar() ? 0 : -0.3}, {0.3, 0.3, is_planar() ? 0 : 0.3}, {}, dimension};
        settings.limit = 1'000'000;
        const SampleSet samples = sample_shapes(scene.shapes, scene.bodies, scene.state, settings);
        const auto count = scene.state.position.size();
        body::Motion motion;
        for (std::size_t b = 0; b < count; ++b) {
            motion.pose.push_back({scene.state.position[b], scene.state.orientation[b]});
        }
        motion.velocity.resize(count);
        motion.angular_velocity.resize(count);
        motion.acceleration.resize(count);
        motion.angular_acceleration.resize(count);
        fluid::BoundaryParticles particles;
        place_samples(samples, motion, particles, {});
        particles.pressure_force.assign(particles.position.size(), {});
        const fluid::WendlandC2 kernel(h, dimension);
        const double volume = std::pow(dp, dimension);
        for (std::size_t w = 0; w < particles.position.size(); ++w) {
            for (const Vec3& x : water) {
                const Vec3 d = particles.position[w] - x;
                if (norm(d) < 2 * h) {
                    particles.pressure_force[w] -= 2 * volume * particles.volume[w] * kernel.slope_over_r(norm(d)) * d;
                }
            }
        }
        body::Loads loads;
        gather(samples, motion, particles.position, particles.pressure_force, loads);
        const CornerLoads corners(scene.shapes, scene.bodies, scene.state, settings, samples);
        if (hands_over) {
            corners.hand_over(samples, motion, particles, loads);
        }
        return loads.force;
    }
};

Vec3 sum(const std::vector<Vec3>& forces) {
    Vec3 all{};
    for (const Vec3& f : forces) {
        all += f;
    }
    return all;
}

/// Water in the corner of a wall at x = 0 and a floor at y = 0.
struct Wall {
    const char* name;
    double low, thickness;
};

TEST(CornerLoads, a_wall_bears_the_pressure_on_its_face_whether_it_goes_on_below_the_floor_or_stands_on_it) {
    for (const Wall& wall : {Wall{"goes on below", -0.2, 0.2}, Wall{"stands on it", 0, 0.2},
                             Wall{"stands on it, thinner than the water looks", 0, 0.5 * dp},
                             Wall{"goes on below, thinner than the water looks", -0.2, 0.5 * dp}}) {
        Tank tank(true);
        tank.scene.add_half_space({0, 1, 0}, 0);
        tank.add_box({0, wall.low, 0}, {wall.thickness, 0.3, 0});
        tank.fill({-side, 0, 0});
        const std::vector<Vec3> plain = tank.forces(false), found = tank.forces();
        const bool is_thin = wall.thickness < 2 * h;
        EXPECT_NEAR(found[1].x - plain[1].x, 0.05 * side, 0.025 * side) << wall.name;  // what it lacked
        if (!is_thin) {
            EXPECT_NEAR(found[1].x, side, rough * side) << wall.name;
        }
        EXPECT_NEAR(-found[0].y, side, rough * side) << wall.name;
        EXPECT_LT(norm(sum(found) - sum(plain)), 1e-12) << wall.name;
    }
}

TEST(CornerLoads, three_walls_that_meet_in_space_bear_the_pressure_on_their_faces) {
    for (const double beyond : {0.0, 0.2}) {  // the end ends on the others, or goes on in them
        Tank tank(false);
        tank.scene.add_half_space({0, 0, 1}, 0);
        tank.scene.add_half_space({0, 1, 0}, 0);
        tank.add_box({0, -beyond, -beyond}, {0.2, 0.3, 0.3});
        tank.fill({-side, 0, 0});
        const std::vector<Vec3> plain = tank.forces(false), found = tank.forces();
        const double area = side * side;
        EXPECT_LT(plain[2].x, 0.97 * area);
        EXPECT_NEAR(found[2].x, area, rough * area);
        EXPECT_NEAR(-found[0].z, area, rough * area);
        EXPECT_NEAR(-found[1].y, area, rough * area);
        EXPECT_LT(norm(sum(found) - sum(plain)), 1e-12);
    }
}

TEST(CornerLoads, a_thin_wall_between_equal_waters_is_not_pushed) {
    Tank tank(true);
    tank.scene.add_half_space({0, 1, 0}, 0);
    tank.add_box({0, 0, 0}, {dp, 0.3, 0});
    tank.fill({-side, 0, 0});
    tank.fill({dp, 0, 0});
    const std::vector<Vec3> found = tank.forces();
    EXPECT_NEAR(found[1].x, 0, 0.01 * side);
}

TEST(CornerLoads, floors_that_lie_flush_hand_nothing_over) {
    Tank tank(true);
    tank.add_box({-0.3, -0.2, 0}, {-0.08, 0, 0});
    tank.add_box({-0.08, -0.2, 0}, {0.3, 0, 0});
    tank.fill({-side, 0, 0});
    const std::vector<Vec3> plain = tank.forces(false), found = tank.forces();
    EXPECT_EQ(found[0], plain[0]);
    EXPECT_EQ(found[1], plain[1]);
}

}  // namespace
}  // namespace riprap::coupling
