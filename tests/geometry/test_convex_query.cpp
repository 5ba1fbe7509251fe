// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/convex_query.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/random_shapes.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::geometry {
namespace {

TEST(DepthBelowFaces, IsTheDistanceToTheSurfaceInside) {
    ShapeSet shapes;
    const ConvexView view = shapes.view(shapes.add_convex(box({2, 4, 6})));
    std::int32_t face = -1;
    EXPECT_EQ(depth_below_faces(view, {0.5, 0, 0}, &face), 0.5);
    EXPECT_EQ(view.normal(face), (Vec3{1, 0, 0}));
    EXPECT_EQ(depth_below_faces(view, {0, 0, -4}, &face), -1);
    EXPECT_EQ(view.normal(face), (Vec3{0, 0, -1}));
}

TEST(Contains, CountsTheSurfaceAndAMarginAsInside) {
    ShapeSet shapes;
    const ConvexView view = shapes.view(shapes.add_convex(cube(2)));
    EXPECT_TRUE(contains(view, {0.9, -0.9, 0.9}));
    EXPECT_TRUE(contains(view, {1, 1, 1}));
    EXPECT_FALSE(contains(view, {1.001, 0, 0}));
    EXPECT_TRUE(contains(view, {1.001, 0, 0}, 0.01));
}

TEST(ClosestSurfacePoint, OfABoxIsTheClampedPoint) {
    ShapeSet shapes;
    const ConvexView view = shapes.view(shapes.add_convex(box({2, 2, 2})));
    std::mt19937_64 random(51);
    for (int trial = 0; trial < 1000; ++trial) {
        const Vec3 x = 3.0 * testing::random_point(random);
        const Vec3 clamped = min(max(x, Vec3{-1, -1, -1}), Vec3{1, 1, 1});
        const SurfacePoint found = closest_surface_point(view, x);
        if (contains(view, x)) {
            const double depth = 1 - std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
            EXPECT_NEAR(found.distance, -depth, 1e-15);
            EXPECT_NEAR(norm(found.point - x), depth, 1e-15);
        } else {
            EXPECT_NEAR(norm(found.point - clamped), 0, 1e-14);
            EXPECT_NEAR(found.distance, norm(x - clamped), 1e-14);
            EXPECT_NEAR(norm(found.normal - normalized(x - clamped)), 0, 1e-13);
        }
    }
}

// A point p of a convex body is the nearest to x exactly when no part of the body is beyond p along x - p.
TEST(ClosestSurfacePoint, OfRandomBlocksSatisfiesTheOptimalityCondition) {
    std::mt19937_64 random(52);
    ShapeSet shapes;
    for (int trial = 0; trial < 200; ++trial) {
        const ConvexView view = shapes.view(shapes.add_convex(testing::random_block(random, 12, {1, 0.6, 0.3})));
        for (int k = 0; k < 50; ++k) {
            const Vec3 x = 2.0 * testing::random_point(random);
            const SurfacePoint found = closest_surface_point(view, x);
            EXPECT_NEAR(depth_below_faces(view, found.point), 0, 1e-14);
            EXPECT_NEAR(norm(found.point + found.distance * found.normal - x), 0, 1e-14);
            EXPECT_NEAR(view.offset[found.face] - dot(view.normal(found.face), found.point), 0, 1e-14);
            if (found.distance > 0) {
                const Vec3 farthest = view.vertex(support_vertex(view, found.normal));
                EXPECT_LE(dot(found.normal, farthest - found.point), 1e-13);
            } else {
                EXPECT_EQ(found.distance, -depth_below_faces(view, x));
            }
        }
    }
}

TEST(ClosestSurfacePoint, OnTheSurfaceHasTheNormalOfItsFace) {
    ShapeSet shapes;
    const ConvexView view = shapes.view(shapes.add_convex(cube(2)));
    const SurfacePoint found = closest_surface_point(view, {0.25, 1, 0.5});
    EXPECT_EQ(found.distance, 0);
    EXPECT_EQ(found.normal, (Vec3{0, 1, 0}));
}

TEST(ClosestSurfacePoint, OfAHalfSpaceIsTheFootOnItsPlane) {
    ShapeSet shapes;
    const ConvexView view = shapes.view(shapes.add_half_space({0, 0, 2}, 6));
    const SurfacePoint above = closest_surface_point(view, {1, 2, 5}), below = closest_surface_point(view, {1, 2, -5});
    EXPECT_EQ(above.point, (Vec3{1, 2, 3}));
    EXPECT_EQ(above.distance, 2);
    EXPECT_EQ(above.normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(below.point, (Vec3{1, 2, 3}));
    EXPECT_EQ(below.distance, -8);
}

}  // namespace
}  // namespace riprap::geometry
