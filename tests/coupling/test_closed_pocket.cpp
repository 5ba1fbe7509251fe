// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/closed_pocket.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/tank_scenes.hpp"

namespace riprap::coupling {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double dp = 0.05;

/// A tank of boxes with water in it, all turned about the origin and moved.
struct Tank {
    test::Scene scene;
    fluid::ParticleState water;
    fluid::ParticleSettings settings;
    Pose frame;
    int dimension;

    explicit Tank(int dimension_ = 2, Pose frame_ = {}) : frame(frame_), dimension(dimension_) {
        scene.bodies.is_planar = dimension == 2;
        settings.spacing = dp;
        settings.sound_speed = 30;
        settings.particle_mass = settings.rest_density * std::pow(dp, dimension);
        settings.domain = {{-9, -9, -9}, {9, 9, 9}, {}, dimension};
    }
    BodyId add_box(const Vec3& low, const Vec3& high, body::Drive drive = body::Drive::fixed) {
        const Pose pose{to_world(frame, 0.5 * (low + high)), frame.orientation};
        return scene.add(geometry::box(high - low), pose, drive);
    }
    /// A floor, two walls and a lid about the room from `low` to `high`, walls behind and before in space.
    BodyId add_walls(const Vec3& low, const Vec3& high) {
        const double t = 0.3, deep = dimension == 2 ? 0.5 : t;
        const Vec3 a = low - Vec3{t, t, deep}, b = high + Vec3{t, t, deep};
        add_box(a, {b.x, low.y, b.z});
        add_box(a, {low.x, b.y, b.z});
        add_box({high.x, a.y, a.z}, b);
        if (dimension == 3) {
            add_box(a, {b.x, b.y, low.z});
            add_box({a.x, a.y, high.z}, b);
        }
        return add_box({a.x, high.y, a.z}, b, body::Drive::driven);
    }
    void pour(const Vec3& low, const Vec3& high, double density = 1000) {
        for (double x = low.x + 0.5 * dp; x < high.x; x += dp) {
            for (double y = low.y + 0.5 * dp; y < high.y; y += dp) {
                for (double z = dimension == 3 ? low.z + 0.5 * dp : 0; z < (dimension == 3 ? high.z : dp); z += dp) {
                    water.add(to_world(frame, {x, y, z}), {}, density, static_cast<std::int32_t>(water.size()));
                }
            }
        }
    }
    std::string look(const Vec3& velocity_of_last = {}) const {
        body::Motion motion;
        const auto count = static_cast<std::size_t>(scene.bodies.size());
        for (std::size_t b = 0; b < count; ++b) {
            motion.pose.push_back({scene.state.position[b], scene.state.orientation[b]});
        }
        motion.velocity.resize(count);
        motion.angular_velocity.resize(count);
        motion.velocity.back() = velocity_of_last;
        return crowded_pocket({scene.shapes, scene.bodies, {}, motion}, settings, water, 0.25);
    }
};

const Pose turned{{0.3, -0.2, 0.1}, from_rotation_vector({0, 0, 37 * 3.14159265358979 / 180})};

TEST(ClosedPocket, ThatKeepsItsVolumeIsNone) {
    Tank tank;
    tank.add_walls({0, 0, 0}, {1, 0.5, 0});
    tank.pour({0, 0, 0}, {1, 0.5, 0}, 1025);
    EXPECT_THAT(tank.look({0, -0.3, 0}), IsEmpty());
}

TEST(ClosedPocket, IsNamedWithTheBodyThatTakesItsRoom) {
    for (const Pose& frame : {Pose{}, turned}) {
        Tank tank(2, frame);
        const BodyId lid = tank.add_walls({0, 0, 0}, {1, 0.5, 0});
        tank.pour({0, 0, 0}, {1, 0.5, 0}, 1035);
        const std::string text = tank.look(rotate(frame.orientation, {0, -0.3, 0}));
        EXPECT_THAT(text, AllOf(HasSubstr(tank.scene.bodies.name(lid) + " leaves"), HasSubstr("3.5 % denser"),
                                HasSubstr(" m, 0.5"), HasSubstr("body0")));
    }
}

TEST(ClosedPocket, IsTooSmallForItsWaterWhateverDensityThatCarries) {
    // 20 rows in the height of 19: 5.3 % more than there is room for.
    for (const int dimension : {2, 3}) {
        Tank tank(dimension);
        tank.add_walls({0, 0, 0}, {0.4, 0.95, 0.4});
        tank.pour({0, 0, 0}, {0.4, 0.95, 0.4});
        for (Vec3& x : tank.water.position) {
            x.y *= 0.95;
        }
        tank.pour({0, 0.95, 0}, {0.4, 0.99, 0.4});
        for (std::size_t i = 0; i < tank.water.position.size(); ++i) {
            tank.water.position[i].y = std::min(tank.water.position[i].y, 0.93);
        }
        EXPECT_THAT(tank.look(), HasSubstr("5.26 % denser")) << dimension;
    }
}

TEST(ClosedPocket, IsNoneBelowASurfaceOrAnOpening) {
    Tank half_full;  // a lid that sends sound through the water at its impact
    half_full.add_walls({0, 0, 0}, {1, 1, 0});
    half_full.pour({0, 0, 0}, {1, 0.8, 0}, 1060);
    EXPECT_THAT(half_full.look(), IsEmpty());

    Tank open;  // no lid
    open.add_box({-0.3, -0.3, -0.5}, {1.3, 0, 0.5});
    open.add_box({-0.3, 0, -0.5}, {0, 1, 0.5});
    open.add_box({1, 0, -0.5}, {1.3, 1, 0.5});
    open.pour({0, 0, 0}, {1, 1, 0}, 1060);
    EXPECT_THAT(open.look(), IsEmpty());

    Tank leaky;  // a gap of two spacings beside the lid
    leaky.add_box({-0.3, -0.3, -0.5}, {1.3, 0, 0.5});
    leaky.add_box({-0.3, 0, -0.5}, {0, 1.5, 0.5});
    leaky.add_box({1, 0, -0.5}, {1.3, 1.5, 0.5});
    leaky.add_box({0, 0.5, -0.5}, {1 - 2 * dp, 0.8, 0.5});
    leaky.pour({0, 0, 0}, {1, 0.5, 0}, 1060);
    EXPECT_THAT(leaky.look(), IsEmpty());
}

TEST(ClosedPocket, IsShutByAGapThatNoParticlePasses) {
    Tank tank;
    tank.add_box({-0.3, -0.3, -0.5}, {1.3, 0, 0.5});
    tank.add_box({-0.3, 0, -0.5}, {0, 1.5, 0.5});
    tank.add_box({1, 0, -0.5}, {1.3, 1.5, 0.5});
    const BodyId piston = tank.add_box({0.1 * dp, 0.5, -0.5}, {1 - 0.1 * dp, 0.8, 0.5}, body::Drive::free);
    tank.pour({0, 0, 0}, {1, 0.5, 0}, 1040);
    EXPECT_THAT(tank.look(), HasSubstr(tank.scene.bodies.name(piston) + " leaves"));  // of those at rest the loose one
}

TEST(ClosedPocket, IsToldFromAnotherOne) {
    Tank tank;
    tank.add_walls({0, 0, 0}, {1, 0.5, 0});
    tank.add_box({0.45, 0, -0.5}, {0.6, 0.5, 0.5});
    tank.pour({0, 0, 0}, {0.45, 0.5, 0}, 1005);
    tank.pour({0.6, 0, 0}, {1, 0.5, 0}, 1040);
    EXPECT_THAT(tank.look(), AllOf(HasSubstr("about (0.8, 0.25, 0)"), HasSubstr("0.2 m^2"), HasSubstr("body4")));
}

TEST(ClosedPocket, GoesRoundOverPeriodicSides) {
    Tank tank;
    tank.settings.domain = {{0, -1, 0}, {1, 2, 0}, {true, false, false}, 2};
    tank.add_box({-2, -0.3, -0.5}, {3, 0, 0.5});
    const BodyId lid = tank.add_box({0, 0.5, -0.5}, {1, 0.8, 0.5}, body::Drive::driven);
    tank.pour({0, 0, 0}, {1, 0.5, 0}, 1040);
    EXPECT_THAT(tank.look({0, -0.1, 0}), HasSubstr(tank.scene.bodies.name(lid) + " leaves"));
}

TEST(ClosedPocket, NarrowerThanThreeSpacingsIsNoneAsPoresBetweenBlocksAre) {
    for (const int rows : {2, 3}) {
        Tank tank;
        tank.add_walls({0, 0, 0}, {1, rows * dp, 0});
        tank.pour({0, 0, 0}, {1, rows * dp, 0}, 1060);
        EXPECT_EQ(tank.look().empty(), rows < 3) << rows;
    }
}

TEST(ClosedPocket, IsLookedForInWaterWhoseDensityTellsNothing) {
    Tank tank;
    tank.pour({0, 0, 0}, {1, 1, 0}, 1000);
    const double piece = 20 * dp / tank.settings.sound_speed;
    EXPECT_TRUE(is_time_to_look(tank.settings, tank.water, {0.9 * piece, 0.2 * piece}, false));
    EXPECT_FALSE(is_time_to_look(tank.settings, tank.water, {0.4 * piece, 0.2 * piece}, false));
    EXPECT_FALSE(is_time_to_look(tank.settings, tank.water, {0.9 * piece, 0.2 * piece}, true));
}

TEST(ClosedPocket, IsLookedForWhereWaterIsDenseAndSoundHasHadTime) {
    Tank tank;
    tank.pour({0, 0, 0}, {1, 1, 0}, 1019);
    const double piece = 8 * dp / tank.settings.sound_speed;
    EXPECT_FALSE(is_time_to_look(tank.settings, tank.water, {0.9 * piece, 0.2 * piece}, true));  // not dense
    for (std::size_t i = 0; i < 9; ++i) {
        tank.water.density[i] = 1021;
    }
    EXPECT_TRUE(is_time_to_look(tank.settings, tank.water, {0.9 * piece, 0.2 * piece}, true));
    EXPECT_FALSE(is_time_to_look(tank.settings, tank.water, {0.7 * piece, 0.2 * piece}, true));
    tank.water.density[0] = 1000;  // fewer than make a pocket
    EXPECT_FALSE(is_time_to_look(tank.settings, tank.water, {0.9 * piece, 0.2 * piece}, true));
}

}  // namespace
}  // namespace riprap::coupling
