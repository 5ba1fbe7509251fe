// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "riprap/geometry/polyhedra/outcome.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

// The usual convex blocks. Faces are polygons (not triangles) that wind counter-clockwise seen from outside. Lengths
// are positive and finite: the reader of the case file has checked single numbers; functions whose *combination* of
// numbers can be wrong return an Outcome.

namespace riprap::geometry {

/// Cuboid with edges along the axes, centred on the origin. @param size  edge lengths [m]
Polyhedron box(const Vec3& size);
/// Cube centred on the origin. @param edge  [m]
Polyhedron cube(double edge);

/// Regular tetrahedron centred on the origin, on alternate corners of a cube: (1,1,1), (1,-1,-1), (-1,1,-1), (-1,-1,1).
/// @param edge  [m]
Polyhedron regular_tetrahedron(double edge);
/// Regular octahedron centred on the origin, corners on the axes. @param edge  [m]
Polyhedron octahedron(double edge);
/// Regular dodecahedron centred on the origin, 12 pentagons. @param edge  [m]
Polyhedron dodecahedron(double edge);
/// Regular icosahedron centred on the origin, 20 triangles. @param edge  [m]
Polyhedron icosahedron(double edge);
/// Ball about the origin as 320 triangles, an icosahedron divided twice, with the volume of the ball: its corners lie
/// 1.2 % outside of it. @param radius  of the ball [m]
Polyhedron sphere(double radius);
/// Tells whether a shape is one of sphere(), about whatever centre.
bool is_sphere(const Polyhedron& shape);

/// Tetrahedron on four points in any order. Refused when they are not finite or lie in one plane.
Outcome<Polyhedron> tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Right prism over a regular polygon, axis along z, centred on the origin, first corner on the +x side of the axis.
/// @param sides         3 or more
/// @param circumradius  from the axis to the corners [m]
/// @param height        [m]
Outcome<Polyhedron> prism(int sides, double circumradius, double height);

/// Right pyramid over a regular polygon: base in z = 0, apex at (0, 0, height).
/// @param sides  3 or more; 4 with circumradius a / sqrt(2) has a square base of side a
Outcome<Polyhedron> pyramid(int sides, double circumradius, double height);

/// Wedge over the rectangle [0, size.x] x [0, size.y] in z = 0 that narrows along x to the strip
/// [top_begin, top_end] x [0, size.y] in z = size.z [m]. top_begin = top_end is a ridge; both 0 is the right-angled
/// wedge with its upright face in x = 0; 0 < top_begin < top_end < size.x a trapezoidal block. Other faces may
/// overhang: the top may lie anywhere. Refused when top_begin > top_end.
Outcome<Polyhedron> wedge(const Vec3& size, double top_begin, double top_end);
/// The right-angled wedge, wedge(size, 0, 0).
Polyhedron wedge(const Vec3& size);

/// A point in the x-y plane [m].
using Point2 = std::array<double, 2>;

/// Prism over a convex polygon in the x-y plane, from z = bottom to z = top.
/// Refused: fewer than 3 corners, non-finite numbers, repeated corners, clockwise order, a corner that is straight or
/// bends inwards, a polygon that winds more than once, top not above bottom.
Outcome<Polyhedron> extruded_polygon(std::span<const Point2> corners, double bottom, double top);

/// The shape of a planar scene: a convex polygon one unit thick, z from -1/2 to +1/2 [m], end faces marked internal.
Outcome<Polyhedron> planar_prism(std::span<const Point2> corners);

}  // namespace riprap::geometry
