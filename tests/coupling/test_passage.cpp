// SPDX-License-Identifier: Apache-2.0
// Particles that go through the places where walls meet.
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/tank_scenes.hpp"
#include "riprap/coupling/particle_walls/penalty_walls.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"
#include "riprap/geometry/ground/ground_cells.hpp"

namespace riprap::coupling {
namespace {

constexpr double dp = 0.05;
constexpr double t = 1.2 * dp;  ///< thickness of walls [m]

/// Walls in the plane or in space, and how many times a particle is counted that goes from place to place in steps.
class Walls {
 public:
    explicit Walls(int dimension = 2) {
        scene_.bodies.is_planar = dimension == 2;
        settings_.spacing = dp;
        settings_.particle_mass = settings_.rest_density * std::pow(dp, dimension);
        settings_.sound_speed = 30;
        settings_.domain = {{-3, -3, -3}, {3, 3, 3}, {}, dimension};
    }

    /// Adds a body of convex pieces where they are.
    Walls& add(const std::vector<geometry::Polyhedron>& pieces, body::Drive drive = body::Drive::fixed) {
        std::vector<body::Part> parts;
        for (const geometry::Polyhedron& piece : pieces) {
            Vec3 place;
            const ShapeId shape = scene_.shapes.add_convex(piece, scene_.bodies.is_planar, &place);
            parts.push_back({BodyId{}, shape, {place, {}}});
        }
        scene_.add_parts(parts, {}, drive);
        return *this;
    }
    Walls& box(const Vec3& low, const Vec3& high, body::Drive drive = body::Drive::fixed) {
        return add({box_of(low, high)}, drive);
    }
    geometry::Polyhedron box_of(const Vec3& low, const Vec3& high) const {
        if (scene_.bodies.is_planar) {
            return polygon_of({{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}});
        }
        geometry::Polyhedron box = geometry::box(high - low);
        for (Vec3& vertex : box.vertices) {
            vertex += 0.5 * (low + high);
        }
        return box;
    }
    static geometry::Polyhedron polygon_of(const std::vector<geometry::Point2>& corners) {
        return geometry::planar_prism(corners).value();
    }
    Walls& repeat_along_x() {
        settings_.domain.is_periodic[0] = true;
        return *this;
    }
    Walls& floor() {
        scene_.add_half_space({0, 1, 0}, 0);
        return *this;
    }

    std::int64_t count(const std::vector<Vec3>& path, double step) const {
        std::int64_t all = 0;
        for (std::size_t leg = 1; leg < path.size(); ++leg) {
            const Vec3 way = path[leg] - path[leg - 1];
            const int steps = std::max(1, static_cast<int>(std::ceil(norm(way) / step)));
            for (int i = 0; i < steps; ++i) {
                all += count_step(path[leg - 1] + static_cast<double>(i + 1) / steps * way, 1.0 / steps * way);
            }
        }
        return all;
    }

 private:
    std::int64_t count_step(const Vec3& x, const Vec3& way) const {
        const double dt = 1e-3;
        fluid::ParticleState particles;
        particles.add(x, 1 / dt * way, settings_.rest_density, 0);
        body::Motion motion;
        for (const Vec3& place : scene_.state.position) {
            motion.pose.push_back({place, {}});
        }
        motion.velocity.resize(motion.pose.size());
        motion.angular_velocity = motion.acceleration = motion.angular_acceleration = motion.velocity;
        fluid::SparseVectors force;
        FluidLoads loads;
        PenaltyWalls walls;
        walls.push(scene_.shapes, scene_.bodies, motion, {}, penalty_settings(settings_, dt), {}, particles, force,
                   loads);
        return walls.passages().count;
    }

    test::Scene scene_;
    fluid::SphSettings settings_;
};

const std::vector<double> sizes{0.0041 * dp, 0.031 * dp, 0.2 * dp};  ///< of steps [m]

/// Corners of two walls about water at x > 0, y > 0.
std::vector<Walls> corners() {
    std::vector<Walls> all(7);
    all[0].box({-0.2, -t, 0}, {1, 0, 0}).box({-t, 0, 0}, {0, 1, 0});       // one stands on the other, which goes on
    all[1].box({-t, -t, 0}, {1, 0, 0}).box({-t, 0, 0}, {0, 1, 0});         // and ends with it
    all[2].box({-t, -t, 0}, {1, 0, 0}).box({-t, -t, 0}, {0, 1, 0});        // both fill the corner
    all[3].add({Walls::polygon_of({{0, 0}, {-t, -t}, {1, -t}, {1, 0}})});  // mitred
    all[3].add({Walls::polygon_of({{0, 0}, {0, 1}, {-t, 1}, {-t, -t}})});
    all[4].floor().box({-t, 0, 0}, {0, 1, 0});
    all[5].add({all[5].box_of({-0.2, -t, 0}, {1, 0, 0}), all[5].box_of({-t, 0, 0}, {0, 1, 0})}, body::Drive::free);
    const std::vector<Vec3> ground{{-1, 0, 0}, {-0.7 * t, 0, 0}, {0.2 * t, 0, 0}, {1, 0, 0}};
    all[6].add(geometry::cells_under_line(ground, 0.2)).box({-t, 0, 0}, {0, 1, 0});
    return all;
}

TEST(Passage, AlongTheSeamOfTwoWallsIsCounted) {
    for (const Walls& walls : corners()) {
        for (const double step : sizes) {
            for (const double y : {-0.1 * t, 0.0, 0.1 * t, 0.3 * t}) {
                EXPECT_EQ(walls.count({{0.512 * t, 0.5 * t, 0}, {0.012 * t, y, 0}, {-1.5 * t, y, 0}}, step), 1) << y;
            }
            // In by the inner face of one wall, along the seam, and out by the outer face of the other.
            const std::vector<Vec3> path{{0.512 * t, -0.02 * t, 0}, {-0.7 * t, -0.02 * t, 0}, {-1.2 * t, 0.4 * t, 0}};
            EXPECT_EQ(walls.count(path, step), 1) << step;
            EXPECT_EQ(walls.count({path[2], path[1], path[0]}, step), 1) << step;
        }
    }
}

TEST(Passage, IntoACornerAndBackIsNone) {
    for (const Walls& walls : corners()) {
        for (const double step : sizes) {
            const std::vector<Vec3> path{{0.3 * t, 0.3 * t, 0},   {-0.3 * t, -0.2 * t, 0}, {0.3 * t, -0.2 * t, 0},
                                         {-0.2 * t, 0.3 * t, 0},  {-0.35 * t, 0, 0},       {0, -0.35 * t, 0},
                                         {-0.2 * t, -0.2 * t, 0}, {0.3 * t, 0.3 * t, 0}};
            EXPECT_EQ(walls.count(path, step), 0) << step;
        }
    }
}

TEST(Passage, FromTheInsideOfATankToTheOutsideIsCountedHoweverThePathRuns) {
    Walls tank;
    tank.box({-t, -t, 0}, {1 + t, 0, 0}).box({-t, 1, 0}, {1 + t, 1 + t, 0});
    tank.box({-t, 0, 0}, {0, 1, 0}).box({1, 0, 0}, {1 + t, 1, 0});
    for (int i = 0; i < 40; ++i) {  // around the corner at 0, through places about it
        const double angle = 0.02 + 0.04 * i, far = 2.1 * t;
        for (const double share : {-0.9, -0.4, 0.1, 0.45}) {
            const Vec3 inside{far * std::cos(angle), far * std::sin(angle), 0};
            const Vec3 outside{-far * std::cos(1.3 * angle) - t, -far * std::sin(1.3 * angle) - t, 0};
            EXPECT_EQ(tank.count({inside, {share * t, 0.3 * share * t, 0}, outside}, sizes[1]), 1) << i << ' ' << share;
        }
    }
}

TEST(Passage, AroundAFreeEndOrAnOuterCornerIsNone) {
    Walls corner;
    corner.box({-t, -t, 0}, {0.5, 0, 0}).box({-t, 0, 0}, {0, 0.25, 0}).box({-t, 0.25, 0}, {0, 0.5, 0});
    for (const double step : sizes) {
        // Around the end of a wall of two parts, near and far, and cutting its corners.
        for (const double y : {0.5 - 0.1 * t, 0.5 + 0.01 * t, 0.5 + 0.2 * t}) {
            EXPECT_EQ(corner.count({{t, 0.3, 0}, {t, y, 0}, {-2 * t, y, 0}, {-2 * t, 0.3, 0}}, step), 0) << y;
        }
        EXPECT_EQ(corner.count({{0.01 * t, 0.4, 0}, {-0.5 * t, 0.5 - 0.4 * t, 0}, {-1.1 * t, 0.5, 0}}, step), 0);
        // Past the outer corner of both, and through its tip.
        for (const double cut : {-0.3 * t, 0.01 * t, 0.3 * t}) {
            EXPECT_EQ(corner.count({{-3 * t + cut, t + cut, 0}, {t + cut, -3 * t + cut, 0}}, step), 0) << cut;
        }
    }
}

TEST(Passage, ThroughTheEdgeOfABlockIsNoneUnlessItIsSharp) {
    for (const double half_deg : {20.0, 28.0, 34.0, 40.0, 50.0}) {
        const double slope = std::tan(half_deg / 180 * 3.14159265358979);
        Walls wedge;  // its edge at 0
        wedge.add({Walls::polygon_of({{0, 0}, {-1, slope}, {-1, -slope}})});
        const std::vector<Vec3> path{{-0.41 * t, 0.613 * t, 0}, {-0.41 * t, -0.7 * t, 0}};
        EXPECT_EQ(wedge.count(path, sizes[1]), half_deg < 30 ? 1 : 0) << half_deg;
    }
}

TEST(Passage, ThroughTheFloorUnderAWallIsCountedAndUnderAStepIsNot) {
    for (const double height : {0.3 * t, 1.2 * t, 2.6 * t, 1.0}) {
        Walls walls;
        walls.floor().box({-t, 0, 0}, {0, height, 0});
        const std::int64_t expected = height > 2 * t ? 1 : 0;
        EXPECT_EQ(walls.count({{0.512 * t, -0.4 * t, 0}, {-1.5 * t, -0.4 * t, 0}}, sizes[1]), expected) << height;
    }
}

TEST(Passage, ThroughAGapIsNoneWhereItIsWiderThanATenthOfASpacing) {
    for (const double step : sizes) {
        for (const double share : {0.0, 0.05, 0.09, 0.11, 0.4}) {
            Walls walls;
            walls.box({-0.5, -t, 0}, {-0.5 * share * dp, 0, 0}).box({0.5 * share * dp, -t, 0}, {0.5, 0, 0});
            const std::int64_t expected = share < 0.1 ? 1 : 0;
            EXPECT_EQ(walls.count({{0, 0.31 * t, 0}, {0, -1.5 * t, 0}}, step), expected) << share << ' ' << step;
        }
    }
}

TEST(Passage, WhereABedMeetsItselfAcrossAPeriodIsCounted) {
    Walls bed;
    bed.repeat_along_x().box({-3, -t, 0}, {3, 0, 0});
    for (const double x : {-3.0, 2.99, 3.01}) {
        EXPECT_EQ(bed.count({{x, 0.512 * t, 0}, {x + 0.1 * t, -1.5 * t, 0}}, sizes[1]), 1) << x;
    }
}

TEST(Passage, UnderABodyThatForcesMoveIsNone) {
    for (const double step : sizes) {
        Walls walls;
        walls.floor().box({-t, 0, 0}, {0, 1, 0}, body::Drive::free);
        EXPECT_EQ(walls.count({{0.512 * t, 0, 0}, {-1.5 * t, 0, 0}}, step), 0);
        EXPECT_EQ(walls.count({{0.512 * t, t, 0}, {-1.5 * t, t, 0}}, step), 1);
    }
}

TEST(Passage, ThroughTheCornerOfAFloorAndTwoWallsIsCounted) {
    Walls tank(3);
    tank.box({-t, -t, -t}, {1, 1, 0}).box({-t, -t, 0}, {0, 1, 1}).box({0, -t, 0}, {1, 0, 1});
    for (const double step : {sizes[1], sizes[2]}) {
        for (const Vec3& out : {Vec3{-2, -2, -2}, Vec3{-2, 0.1, 0.02}, Vec3{-2, -2, 0.02}, Vec3{-0.2, -0.3, -2}}) {
            EXPECT_EQ(tank.count({{0.5 * t, 0.512 * t, 0.53 * t}, {0.01 * t, 0.02 * t, 0.01 * t}, t * out}, step), 1);
        }
        EXPECT_EQ(
            tank.count({{0.5 * t, 0.5 * t, 0.5 * t}, {-0.3 * t, -0.25 * t, -0.2 * t}, {0.2 * t, 0.5 * t, 0}}, step), 0);
    }
}

}  // namespace
}  // namespace riprap::coupling
