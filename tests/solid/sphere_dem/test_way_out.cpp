// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/way_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "riprap/geometry/polyhedra/convex_hull.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::solid::sphere_dem {
namespace {

std::int32_t face_towards(const geometry::ConvexView& shape, const Vec3& outward) {
    for (std::int32_t f = 0; f < shape.face_count; ++f) {
        if (dot(shape.normal(f), outward) > 1 - 1e-9) {
            return f;
        }
    }
    return -1;
}

TEST(WayOut, AtAnEdgeIsHalfwayBetweenFacesThatAreAsNear) {
    geometry::ShapeSet shapes;
    const geometry::ConvexView cube = shapes.view(shapes.add_convex(geometry::cube(1)));  // its inscribed radius is 0.5
    for (const double farther : {0.0, 4e-7, 6e-7}) {
        const Vec3 point{0.49, 0.49 - farther, 0.1};
        const MiddleWay way = middle_way_out(cube, point, face_towards(cube, {1, 0, 0}));
        if (farther < 5e-7) {
            EXPECT_NEAR(norm(way.outward - Vec3{1, 1, 0} / std::sqrt(2.0)), 0, 1e-12) << farther;
            EXPECT_NEAR(way.length, 0.01 * std::sqrt(2.0), 1e-12) << farther;
        } else {
            EXPECT_EQ(way.length, 0) << farther;
        }
    }
    const MiddleWay corner = middle_way_out(cube, {0.49, 0.49, -0.49}, face_towards(cube, {1, 0, 0}));
    EXPECT_NEAR(corner.length, 0.01 * std::sqrt(3.0), 1e-12);
}

TEST(WayOut, BetweenFacesThatLookAwayFromEachOtherIsNone) {
    geometry::ShapeSet shapes;
    const geometry::ConvexView plate = shapes.view(shapes.add_convex(geometry::box({1, 1, 0.1})));
    EXPECT_EQ(middle_way_out(plate, {}, face_towards(plate, {0, 0, 1})).length, 0);
    // The faces of a wedge leave a way out in the middle down to 0.1 of their normals along it.
    for (const double sine : {0.07, 0.15}) {
        const double half_width = sine / std::sqrt(1 - sine * sine);
        const std::vector<Vec3> corners{
            {0, 0, -1},          {0, 0, 1}, {-1, half_width, -1}, {-1, half_width, 1}, {-1, -half_width, -1},
            {-1, -half_width, 1}};
        const geometry::ConvexView wedge = shapes.view(shapes.add_convex(geometry::convex_hull(corners).value()));
        double to_tip = 0;
        for (int v = 0; v < wedge.vertex_count; ++v) {
            to_tip = std::max(to_tip, wedge.vertex(v).x);
        }
        const Vec3 upper{sine, std::sqrt(1 - sine * sine), 0};
        const MiddleWay way = middle_way_out(wedge, {to_tip - 0.05, 0, 0}, face_towards(wedge, upper));
        EXPECT_NEAR(way.length, sine < 0.1 ? 0 : 0.05, 1e-9) << sine;
    }
}

}  // namespace
}  // namespace riprap::solid::sphere_dem
