// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/convex_hull.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/random_shapes.hpp"
#include "riprap/geometry/polyhedra/half_edge.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::geometry {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;

auto says(const std::string& text) { return Contains(Field(&GeometryProblem::message, HasSubstr(text))); }

std::vector<Vec3> shuffled(std::vector<Vec3> points, std::mt19937_64& random) {
    std::shuffle(points.begin(), points.end(), random);
    return points;
}

TEST(ConvexHull, OfTheCornersOfASolidIsTheSolid) {
    std::mt19937_64 random(41);
    for (const Polyhedron& solid : {cube(1), box({1, 2, 1e-3}), regular_tetrahedron(1), octahedron(1), dodecahedron(1),
                                    icosahedron(1), prism(11, 1, 3).value(), wedge({1, 2, 3})}) {
        for (const double size : {1e-6, 1.0, 1e6}) {
            Polyhedron placed = moved(solid, {testing::random_point(random), testing::random_orientation(random)});
            for (Vec3& x : placed.vertices) {
                x *= size;
            }
            const Outcome<Polyhedron> hull = convex_hull(shuffled(placed.vertices, random));
            ASSERT_TRUE(hull) << hull.problems().front().message;
            EXPECT_EQ(hull.value().vertices.size(), solid.vertices.size());
            EXPECT_EQ(hull.value().faces.size(), solid.faces.size());
            const double volume = mass_properties(placed).volume;
            EXPECT_NEAR(mass_properties(hull.value()).volume, volume, 1e-12 * volume);
        }
    }
}

TEST(ConvexHull, OfRandomPointsIsTheOneFoundByTryingEveryTriangle) {
    std::mt19937_64 random(42);
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<Vec3> points;
        for (int i = 0; i < 12; ++i) {
            points.push_back(testing::random_point(random));
        }
        const Polyhedron hull = convex_hull(points).value();
        const Polyhedron brute = testing::brute_force_hull(points);
        ASSERT_EQ(hull.faces.size(), brute.faces.size());
        const MassProperties ours = mass_properties(hull), theirs = mass_properties(brute);
        EXPECT_NEAR(ours.volume, theirs.volume, 1e-14);
        EXPECT_NEAR(norm(ours.centroid - theirs.centroid), 0, 1e-14);
    }
}

TEST(ConvexHull, KeepsTheNumbersOfItsInput) {
    std::mt19937_64 random(43);
    std::vector<Vec3> points;
    for (int i = 0; i < 30; ++i) {
        points.push_back(Vec3{100, 200, 300} + testing::random_point(random));
    }
    const Polyhedron hull = convex_hull(points).value();
    for (const Vec3& x : hull.vertices) {
        EXPECT_NE(std::find(points.begin(), points.end(), x), points.end());
    }
}

TEST(ConvexHull, LeavesOutPointsThatAreNoCorners) {
    std::vector<Vec3> grid;  // corners, middles of edges and faces, the centre, and every one of them twice
    for (int i = 0; i < 54; ++i) {
        grid.push_back({static_cast<double>(i % 3), static_cast<double>(i / 3 % 3), static_cast<double>(i / 9 % 3)});
    }
    grid.push_back({2 + 1e-12, 2, 2});
    const Polyhedron hull = convex_hull(grid).value();
    EXPECT_EQ(hull.vertices.size(), 8U);
    EXPECT_EQ(hull.faces.size(), 6U);
    EXPECT_NEAR(mass_properties(hull).volume, 8, 1e-11);
}

TEST(ConvexHull, OfManyPointsPassesTheTopologyCheck) {
    std::mt19937_64 random(44);
    std::vector<Vec3> ball, block;
    for (int i = 0; i < 5000; ++i) {
        ball.push_back(testing::random_direction(random));
        block.push_back(testing::random_point(random));
        for (int axis = 0; axis < 3; ++axis) {  // clouds with many points exactly in the faces of a cube
            if (testing::uniform(random) > 0.5) {
                block.back()[axis] = block.back()[axis] > 0 ? 1 : -1;
            }
        }
    }
    EXPECT_EQ(half_edges(convex_hull(ball).value()).value().vertex_count(), 5000);
    EXPECT_EQ(convex_hull(block).value().faces.size(), 6U);
}

TEST(ConvexHull, RefusesPointsWithoutVolume) {
    const auto problems = [](const std::vector<Vec3>& points) { return convex_hull(points).problems(); };
    EXPECT_THAT(problems({}), says("a hull of 0 points has no volume"));
    EXPECT_THAT(problems({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), says("a hull of 3 points has no volume"));
    EXPECT_THAT(problems({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), says("all in one place"));
    EXPECT_THAT(problems({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), says("on one line"));
    EXPECT_THAT(problems({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.4, 0}}), says("in one plane"));
    EXPECT_THAT(problems({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}), says("in one plane"));
    EXPECT_THAT(problems({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.3, 1e-11}}), says("in one plane"));
    EXPECT_THAT(problems({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}, {0, 0, 1}}), says("point 2 of the hull"));
    EXPECT_THAT(problems({{1e308, 0, 0}, {-1e308, 0, 0}, {0, 1, 0}, {0, 0, 1}}), says("too far apart"));
    EXPECT_THAT(problems(std::vector<Vec3>(hull_point_limit + 1)), says("a hull of 1000001 points"));
}

TEST(ConvexHull, OfPlanesAndNeedlesTurnedAnywayIsRightOrRefused) {
    std::mt19937_64 random(45);
    for (int trial = 0; trial < 300; ++trial) {
        const double thin = std::pow(10.0, testing::uniform(random, -12, -2));
        const Polyhedron plate = moved(box(trial % 2 == 0 ? Vec3{1, 0.8, thin} : Vec3{1, thin, thin}),
                                       {testing::random_point(random), testing::random_orientation(random)});
        const Outcome<Polyhedron> hull = convex_hull(plate.vertices);
        if (thin > 1e-8) {
            ASSERT_TRUE(hull) << thin;
            const double volume = mass_properties(plate).volume;
            EXPECT_NEAR(mass_properties(hull.value()).volume, volume, 2e-9 * volume / thin);
        } else if (thin < 1e-10) {
            EXPECT_FALSE(hull) << thin;
        }
    }
}

TEST(RandomHull, IsTheSameBlockForTheSameSeed) {
    const Polyhedron a = random_hull(7, 12, 2).value(), b = random_hull(7, 12, 2).value(),
                     c = random_hull(8, 12, 2).value();
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.faces, b.faces);
    EXPECT_NE(a.vertices, c.vertices);
}

TEST(RandomHull, HasAllItsCornersOnTheSphereAndIsCompact) {
    for (const int corners : {4, 5, 8, 20, 200}) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const Polyhedron block = random_hull(seed, corners, 0.5).value();
            EXPECT_EQ(block.vertices.size(), static_cast<std::size_t>(corners));
            for (const Vec3& x : block.vertices) {
                EXPECT_NEAR(norm(x), 0.5, 1e-15);
            }
            for (const auto& loop : block.faces) {
                EXPECT_GT(face_plane(block.vertices, loop).offset, 0.05 - 1e-12);
            }
        }
    }
}

TEST(RandomHull, RefusesNumbersThatMakeNoBlock) {
    EXPECT_THAT(random_hull(1, 3, 1).problems(), says("3 corners"));
    EXPECT_THAT(random_hull(1, 8, 0).problems(), says("circumradius 0"));
    EXPECT_THAT(random_hull(1, 8, std::nan("")).problems(), says("circumradius nan"));
}

}  // namespace
}  // namespace riprap::geometry
