// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/round_shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace riprap::geometry {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;

auto says(const std::string& text) { return Contains(Field(&GeometryProblem::message, HasSubstr(text))); }

double volume(const Polyhedron& shape) { return mass_properties(shape).volume; }

TEST(Shapes, HaveTheVolumesOfTheTextbook) {
    EXPECT_EQ(volume(box({2, 3, 4})), 24);
    EXPECT_EQ(volume(cube(3)), 27);
    EXPECT_NEAR(volume(prism(6, 2, 5).value()), 6 * std::sqrt(3.0) * 5, 1e-13);  // hexagon 3 sqrt(3)/2 R^2
    EXPECT_NEAR(volume(pyramid(4, std::sqrt(2.0), 3).value()), 4, 1e-14);        // square base of side 2
    EXPECT_NEAR(volume(wedge({2, 3, 4})), 12, 1e-14);
    EXPECT_NEAR(volume(wedge({4, 1, 2}, 1, 2).value()), 5, 1e-14);  // trapezoid of sides 4 and 1
    EXPECT_NEAR(volume(tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}).value()), 1, 1e-15);
}

TEST(Shapes, LieWhereTheirDescriptionSays) {
    const Polyhedron right = wedge({2, 3, 4});
    for (const Vec3& x : right.vertices) {
        EXPECT_TRUE(x.x >= 0 && x.x <= 2 && x.y >= 0 && x.y <= 3 && x.z >= 0 && x.z <= 4);
    }
    const Vec3 centroid = mass_properties(right).centroid;
    EXPECT_NEAR(norm(centroid - Vec3{2.0 / 3, 1.5, 4.0 / 3}), 0, 1e-14);
    EXPECT_NEAR(norm(mass_properties(prism(7, 1, 2).value()).centroid), 0, 1e-15);
    EXPECT_NEAR(norm(mass_properties(pyramid(5, 1, 2).value()).centroid - Vec3{0, 0, 0.5}), 0, 1e-15);
    EXPECT_NEAR(prism(6, 2, 1).value().vertices[0].x, 2, 1e-15);
}

TEST(Tetrahedron, AcceptsItsPointsInAnyOrder) {
    const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
    EXPECT_NEAR(volume(tetrahedron(a, b, c, d).value()), 1.0 / 6, 1e-15);
    EXPECT_NEAR(volume(tetrahedron(a, c, b, d).value()), 1.0 / 6, 1e-15);
}

TEST(Tetrahedron, RefusesPointsOfOnePlaneAndNonFiniteOnes) {
    EXPECT_THAT(tetrahedron({0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {7, 9, 5}).problems(), says("lie in one plane"));
    EXPECT_THAT(tetrahedron({0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}).problems(), says("lie in one plane"));
    EXPECT_THAT(tetrahedron({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}).problems(), says("lie in one plane"));
    EXPECT_THAT(tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, std::nan("")}).problems(), says("not finite"));
    EXPECT_TRUE(tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1e-6}));
}

TEST(PlanarPrism, IsOneUnitThickWithFreeEnds) {
    const std::vector<Point2> triangle{{0, 0}, {2, 0}, {0, 2}};
    const Polyhedron shape = planar_prism(triangle).value();
    EXPECT_NEAR(volume(shape), 2, 1e-15);
    EXPECT_NEAR(mass_properties(shape).centroid.z, 0, 1e-16);
    EXPECT_THAT(shape.is_internal, ElementsAre(1, 1, 0, 0, 0));
}

TEST(ExtrudedPolygon, RefusesWhatIsNotAConvexPolygon) {
    const auto problems = [](std::vector<Point2> corners) { return extruded_polygon(corners, 0, 1).problems(); };
    EXPECT_THAT(problems({{0, 0}, {1, 0}}), says("a polygon of 2 corners"));
    EXPECT_THAT(problems({{0, 0}, {0, 1}, {1, 0}}), says("winds clockwise"));
    EXPECT_THAT(problems({{0, 0}, {2, 0}, {1, 0.5}, {2, 2}, {0, 2}}), says("not convex at corner 2"));
    EXPECT_THAT(problems({{0, 0}, {1, 0}, {2, 0}, {0, 2}}), says("corner 1 of the polygon lies on a straight line"));
    EXPECT_THAT(problems({{0, 0}, {1, 0}, {1, 0}, {0, 2}}), says("corners 1 and 2 of the polygon are the same"));
    EXPECT_THAT(problems({{0, 0}, {1, 0}, {0, 2}, {0, 0}}), says("corners 3 and 0 of the polygon are the same"));
    EXPECT_THAT(problems({{0, 0}, {1, std::numeric_limits<double>::infinity()}, {0, 1}}), says("corner 1"));
    EXPECT_THAT(problems({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), says("crosses itself"));
    std::vector<Point2> star;  // a pentagram turns left at every corner but winds twice
    for (int k = 0; k < 5; ++k) {
        star.push_back({std::cos(4 * std::numbers::pi * k / 5), std::sin(4 * std::numbers::pi * k / 5)});
    }
    EXPECT_THAT(problems(star), says("winds more than once"));
}

TEST(ExtrudedPolygon, RefusesHeightsUpsideDown) {
    const std::vector<Point2> triangle{{0, 0}, {1, 0}, {0, 1}};
    EXPECT_THAT(extruded_polygon(triangle, 1, 1).problems(), says("reaches from 1 m up to 1 m"));
    EXPECT_THAT(extruded_polygon(triangle, 0, std::nan("")).problems(), says("up to nan m"));
}

TEST(Wedge, RefusesATopThatEndsBeforeItBegins) {
    EXPECT_THAT(wedge({1, 1, 1}, 0.6, 0.4).problems(), says("before it begins"));
}

TEST(Sphere, HasTheVolumeOfItsBallAndIsKnownAgain) {
    const Polyhedron ball = sphere(0.3);
    EXPECT_EQ(ball.faces.size(), 320U);
    const MassProperties mass = mass_properties(ball);
    EXPECT_NEAR(mass.volume, 4 * M_PI / 3 * 0.027, 1e-12);
    EXPECT_NEAR(norm(mass.centroid), 0, 1e-15);
    for (const Vec3& corner : ball.vertices) {
        EXPECT_NEAR(norm(corner), 0.3, 0.013 * 0.3);
    }
    EXPECT_TRUE(is_sphere(moved(ball, {{1, 2, 3}, from_rotation_vector({0.3, 1, 2})})));
    EXPECT_FALSE(is_sphere(icosahedron(1)));
    Polyhedron dented = ball;
    dented.vertices[5] *= 0.99;
    EXPECT_FALSE(is_sphere(dented));
}

TEST(RegularPolygons, NeedThreeSides) {
    EXPECT_THAT(prism(2, 1, 1).problems(), says("2 sides"));
    EXPECT_THAT(pyramid(0, 1, 1).problems(), says("0 sides"));
}

TEST(Shapes, EllipsoidsAndCylindersHaveTheirVolume) {
    EXPECT_NEAR(mass_properties(ellipsoid({0.5, 1, 2})).volume, 4 * std::numbers::pi / 3, 1e-12);
    const Vec3 reach{0.5, 1, 2};
    for (const Vec3& v : ellipsoid(reach).vertices) {
        EXPECT_LT(std::abs(v.x / reach.x) + std::abs(v.y / reach.y) + std::abs(v.z / reach.z),
                  1.78);  // sqrt 3 and a bit
    }
    const auto round = cylinder(0.3, 2, 32);
    ASSERT_TRUE(round);
    EXPECT_NEAR(mass_properties(round.value()).volume, std::numbers::pi * 0.09 * 2, 1e-12);
    EXPECT_FALSE(is_sphere(ellipsoid(reach)));
    EXPECT_TRUE(is_sphere(ellipsoid({1, 1, 1})));
}

}  // namespace
}  // namespace riprap::geometry
