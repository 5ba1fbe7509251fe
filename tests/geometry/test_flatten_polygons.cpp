// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "riprap/geometry/polyhedra/flatten_polygons.hpp"
#include "riprap/geometry/polyhedra/merge_faces.hpp"
#include "riprap/geometry/polyhedra/round_shapes.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/geometry/polyhedra/sound_part.hpp"

namespace riprap::geometry {
namespace {

double rounded(double x, bool is_single) {
    return is_single ? static_cast<double>(static_cast<float>(x)) : std::round(x * 1e5) / 1e5;
}

/// A solid turned out of the axes, its corners as a file in single precision or with five decimals keeps them.
Polyhedron turned(Polyhedron solid, double angle, bool is_single) {
    for (Vec3& x : solid.vertices) {
        const double c = std::cos(angle), s = std::sin(angle);
        x = {c * x.x - s * x.y, s * x.x + c * x.y, x.z};
        x = {x.x, c * x.y - s * x.z, s * x.y + c * x.z};
        x = {rounded(x.x, is_single), rounded(x.y, is_single), rounded(x.z, is_single)};
    }
    return solid;
}

/// The height of the highest vertex above a face.
double rise_of(const Polyhedron& part) {
    double most = 0;
    for (const auto& loop : part.faces) {
        const Plane plane = face_plane(part.vertices, loop);
        for (const Vec3& x : part.vertices) {
            most = std::max(most, dot(plane.normal, x) - plane.offset);
        }
    }
    return most;
}

TEST(FlatPolygons, TurnedSolidsOfSinglePrecisionOrFiveDecimalsAreHeld) {
    // Blocks from CAD that do not stand along the axes were refused as out of the range of double precision.
    for (const bool is_single : {true, false}) {
        for (double angle = 0.05; angle < 1.5; angle += 0.1) {
            for (const Polyhedron& solid :
                 {cube(1.3), box({1, 0.3, 0.05}), cylinder(1, 0.7, 32).value(), wedge({1, 2, 0.5}), octahedron(1.1)}) {
                Polyhedron part = turned(solid, angle, is_single);
                const bool is_rough = rise_of(part) > coplanar_tolerance * length_scale(part.vertices);
                EXPECT_EQ(part_problem(part, false).has_value(), is_rough);
                const double volume = mass_properties(part).volume, way = flatten_polygons(part);
                EXPECT_TRUE(way > 0 || !is_rough);
                EXPECT_LT(way, is_single ? 1e-6 : 1e-4);
                ASSERT_FALSE(part_problem(part, false)) << part_problem(part, false)->message;
                EXPECT_NEAR(mass_properties(part).volume, volume, (is_single ? 1e-6 : 1e-4) * volume);
                ShapeSet shapes;
                shapes.add_convex(part);  // asserts convexity
            }
        }
    }
}

TEST(FlatPolygons, CornersInTheirPlanesStayWhereTheyAre) {
    for (const Polyhedron& solid : {cube(1.3), cylinder(1, 0.7, 32).value(), regular_tetrahedron(2)}) {
        Polyhedron part = solid;
        EXPECT_EQ(flatten_polygons(part), 0);
        EXPECT_EQ(part.vertices, solid.vertices);
    }
}

}  // namespace
}  // namespace riprap::geometry
