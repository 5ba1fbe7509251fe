// SPDX-License-Identifier: Apache-2.0
// A driven wall that lies in the floor it slides through: what water in the corner sees of both.
#include "riprap/coupling/samples/moving_seams.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/tank_scenes.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"
#include "riprap/fluid/particle/kernel.hpp"

namespace riprap::coupling {
namespace {

/// Sums at seams are good to 4 % of what a plane wall has (docs/theory/coupling.md, 1), here of two of them.
constexpr double rough = 0.05;
constexpr double dp = 0.02, h = 1.5 * dp, pi = 3.14159265358979;

/// Water before a wall, x < 0, and over a floor, y > 0. The wall is thick and reaches below the floor by `deep`; both
/// are turned by an angle about the corner.
struct Corner {
    test::Scene scene;
    SampleSet samples;
    body::Motion motion;
    fluid::BoundaryParticles particles;
    double angle;
    BodyId floor, wall;

    /// @param lean  of the wall against the upright; its water face turns with it about the corner [rad]
    explicit Corner(double deep, double angle_ = 0, double thickness = 10 * dp, double lean = 0) : angle(angle_) {
        scene.bodies.is_planar = true;
        floor = scene.add_half_space(turned({0, 1, 0}), 0);
        const double height = 3;
        wall = scene.add(geometry::box({thickness, height, 1}),
                         {rotate(from_rotation_vector({0, 0, angle + lean}), {0.5 * thickness, 0.5 * height - deep, 0}),
                          from_rotation_vector({0, 0, angle + lean})},
                         body::Drive::fixed);
        scene.bodies.drive[1] = body::Drive::driven;
        scene.bodies.driven[1] = 0;
        scene.bodies.driven_bodies.push_back({});
        SampleSettings settings;
        settings.spacing = dp;
        settings.reach = 2 * h;
        settings.domain = {{-1, -1, 0}, {1, 1, 0}, {}, 2};
        settings.limit = 100'000;
        samples = sample_shapes(scene.shapes, scene.bodies, scene.state, settings);
        motion.pose = {{scene.state.position[0], scene.state.orientation[0]},
                       {scene.state.position[1], scene.state.orientation[1]}};
        motion.velocity.resize(2);
        motion.angular_velocity.resize(2);
        motion.acceleration.resize(2);
        motion.angular_acceleration.resize(2);
    }
    Vec3 turned(const Vec3& a) const { return rotate(from_rotation_vector({0, 0, angle}), a); }
    MovingSeams seams() const { return {scene.shapes, scene.bodies, {}, motion, dp, 2 * h}; }
    void place_unshared() {
        const std::vector<std::uint8_t> is_still{1, 0};
        place_samples(samples, motion, particles, is_still);
    }
    void place() {
        place_unshared();
        seams().share(samples, particles);
    }
    /// sum V W, and sum V (u - v_w) . grad W beside sum V |u - v_w| |grad W|
    double filling(const Vec3& x) const {
        double sum = 0;
        for (std::size_t i = 0; i < particles.position.size(); ++i) {
            sum += particles.volume[i] * test::wendland(norm(x - particles.position[i]), h, 2);
        }
        return sum;
    }
    double opening(const Vec3& x, const Vec3& u) const {
        const fluid::WendlandC2 kernel(h, 2);
        double sum = 0, scale = 0;
        for (std::size_t i = 0; i < particles.position.size(); ++i) {
            const Vec3 d = x - particles.position[i];
            const Vec3 slope = particles.volume[i] * kernel.slope_over_r(norm(d)) * d;
            sum += dot(u - particles.velocity[i], slope);
            scale += norm(slope);
        }
        return sum / scale;
    }
};

/// The same filling of a corner of 90 degrees in the continuum: all but the quarter of the water.
double exact_filling(const Vec3& x) {
    double water = 0;
    constexpr int n = 60;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Vec3 y{-2 * h * (i + 0.5) / n * 1.5, 2 * h * (j + 0.5) / n * 1.5, 0};
            water += 9 * h * h / n / n * test::wendland(norm(x - y), h, 2);
        }
    }
    return 1 - water;
}

TEST(MovingSeams, FillTheCornerOfAWallThatLiesInTheFloorOnceAtAnyDepth) {
    for (const double deep : {2 * dp, 5.3 * dp, 17.75 * dp}) {
        for (const double angle : {0.0, 37 * pi / 180}) {
            Corner corner(deep, angle);
            corner.place();
            for (const double y : {0.5 * dp, 1.5 * dp}) {
                const Vec3 x{-0.5 * dp, y, 0};
                EXPECT_NEAR(corner.filling(corner.turned(x)), exact_filling(x), 0.04) << deep << ' ' << y;
            }
            corner.place_unshared();
            const Vec3 x{-0.1 * dp, 0.1 * dp, 0};
            const auto count = corner.particles.position.size();
            for (std::size_t i = 0; i < count; ++i) {
                corner.particles.volume[i] = corner.samples.volume[i];  // twice in the shared solid
            }
            EXPECT_GT(corner.filling(corner.turned(x)), exact_filling(x) + 0.1) << deep;
        }
    }
}

TEST(MovingSeams, NeitherDrawNorPressWaterAtRestAsAWallSlidesAlongItself) {
    for (const double deep : {2 * dp, 5.3 * dp, 17.75 * dp}) {
        for (const double angle : {0.0, 37 * pi / 180}) {
            Corner corner(deep, angle);
            corner.motion.velocity[1] = corner.turned({0, -1, 0});
            corner.place();
            for (const double y : {0.5 * dp, 1.5 * dp, 2.5 * dp}) {
                EXPECT_NEAR(corner.opening(corner.turned({-0.5 * dp, y, 0}), {}), 0, rough) << deep << ' ' << y;
            }
        }
    }
}

TEST(MovingSeams, WouldDrawWaterIfSharedSolidStoodStillWithTheFloor) {
    Corner corner(5.3 * dp);
    corner.motion.velocity[1] = {0, -1, 0};
    corner.place();
    for (std::size_t i = 0; i < corner.particles.position.size(); ++i) {
        if (corner.particles.position[i].y < 0) {
            corner.particles.velocity[i] = {};
        }
    }
    EXPECT_GT(std::abs(corner.opening({-0.5 * dp, 0.5 * dp, 0}, {})), 1.5 * rough);
}

TEST(MovingSeams, TakeNothingOfTheFloorAlongUnderAPiston) {
    Corner corner(5.3 * dp);
    corner.motion.velocity[1] = {-1, 0, 0};
    corner.place();
    for (const double y : {0.5 * dp, 1.5 * dp, 2.5 * dp}) {
        EXPECT_NEAR(corner.opening({-0.5 * dp, y, 0}, {-1, 0, 0}), 0, rough) << y;
    }
}

TEST(MovingSeams, LeaveTheLoadOfAWallAcrossItAndKeepTheSum) {
    for (const double deep : {5.3 * dp, 17.75 * dp}) {
        Corner corner(deep, 0);
        corner.place();
        const fluid::WendlandC2 kernel(h, 2);
        corner.particles.pressure_force.assign(corner.particles.position.size(), {});
        for (int i = 0; i < 12; ++i) {
            for (int j = 0; j < 12; ++j) {  // water at one pressure, 2 p V_j = 1
                const Vec3 water{-(i + 0.5) * dp, (j + 0.5) * dp, 0};
                for (std::size_t w = 0; w < corner.particles.position.size(); ++w) {
                    const Vec3 d = corner.particles.position[w] - water;
                    corner.particles.pressure_force[w] -= corner.particles.volume[w] * kernel.slope_over_r(norm(d)) * d;
                }
            }
        }
        body::Loads before, after;
        gather(corner.samples, corner.motion, corner.particles.position, corner.particles.pressure_force, before);
        after = before;
        corner.seams().hand_over(corner.samples, corner.particles, after);
        // 12 rows press on the wall with 6 dp/dp^2 each; those at the open end with less.
        EXPECT_GT(after.force[1].x, 0.5 * 10 / dp);
        EXPECT_LT(after.force[0].y, -0.5 * 10 / dp);
        EXPECT_GT(after.force[1].x, before.force[1].x + 0.01 * before.force[1].x);  // what floor is under the wall felt
        EXPECT_LT(after.force[0].y, before.force[0].y);
        EXPECT_NEAR(norm(after.force[0] + after.force[1] - before.force[0] - before.force[1]), 0, 1e-9);
        EXPECT_NEAR(after.torque[0].z + after.torque[1].z +
                        cross(corner.motion.pose[1].position, after.force[1] - before.force[1]).z,
                    before.torque[0].z + before.torque[1].z, 1e-9);
    }
}

// With rows handed over as a whole, by their middle, walls half a spacing higher bear 1.5 % of that along themselves.
TEST(MovingSeams, LeaveNothingAlongAWallWhateverTheHeightOfItsRows) {
    const fluid::WendlandC2 kernel(h, 2);
    for (const double angle : {0.0, 37 * pi / 180}) {
        for (const double deep : {5 * dp, 5.25 * dp, 5.5 * dp, 5.75 * dp, 5.9 * dp}) {
            Corner corner(deep, angle);
            corner.place();
            corner.particles.pressure_force.assign(corner.particles.position.size(), {});
            for (int i = 0; i < 5; ++i) {
                for (int j = 0; j < 100; ++j) {  // the wall is 150 spacings high
                    const Vec3 water = corner.turned({-(i + 0.5) * dp, (j + 0.5) * dp, 0});
                    const double pressure = (100 - j) / 100.0;
                    for (std::size_t w = 0; w < corner.particles.position.size(); ++w) {
                        const Vec3 d = corner.particles.position[w] - water;
                        corner.particles.pressure_force[w] -=
                            pressure * corner.particles.volume[w] * kernel.slope_over_r(norm(d)) * d;
                    }
                }
            }
            body::Loads loads;
            gather(corner.samples, corner.motion, corner.particles.position, corner.particles.pressure_force, loads);
            corner.seams().hand_over(corner.samples, corner.particles, loads);
            const double across = dot(loads.force[1], corner.turned({1, 0, 0}));
            EXPECT_GT(across, 0.4 * 50 / dp) << deep;
            EXPECT_NEAR(dot(loads.force[1], corner.turned({0, 1, 0})), 0, 0.009 * across) << deep << ' ' << angle;
        }
    }
}

TEST(MovingSeams, LeaveTheVelocityOfSharedSolidWhereFacesMeetAtLessThan18Degrees) {
    for (const double degrees : {16.0, 22.0}) {  // sine squared of 0.076 and 0.14
        Corner corner(1.5, 0, 1.0, (degrees - 90) * pi / 180);
        corner.motion.velocity[1] = {0, -1, 0};
        corner.place_unshared();
        const std::vector<Vec3> before = corner.particles.velocity;
        corner.place();
        int changed = 0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const bool is_near = norm(corner.particles.position[i]) < 0.3;  // of both, the faces that meet are nearest
            changed += is_near && norm(corner.particles.velocity[i] - before[i]) > 1e-12 ? 1 : 0;
        }
        EXPECT_EQ(changed > 0, degrees > 18) << degrees << ": " << changed;
    }
}

TEST(MovingSeams, AreTakenBackOnceTheWallHasLeftTheFloor) {
    Corner corner(5.3 * dp);
    corner.motion.velocity[1] = {0, 1, 0};
    corner.place();
    corner.motion.pose[1].position.y += 1;
    corner.place();
    for (std::size_t i = 0; i < corner.particles.position.size(); ++i) {
        EXPECT_EQ(corner.particles.volume[i], corner.samples.volume[i]);
        EXPECT_EQ(corner.particles.velocity[i].y, corner.samples.body[i] == corner.wall ? 1 : 0);
    }
}

}  // namespace
}  // namespace riprap::coupling
