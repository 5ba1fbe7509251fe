// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/geometry/polyhedra/shapes.hpp"

// Round bodies as polyhedra with their exact volume; a ball is sphere() of shapes.hpp.

namespace riprap::geometry {

/// Ellipsoid about the origin: a sphere() that is stretched. @param semi_axes  [m]
Polyhedron ellipsoid(const Vec3& semi_axes);

/// Cylinder along z about the origin, as a prism over a regular polygon with the area of its circle.
/// @param radius, height  [m]
/// @param sides           3 or more
Outcome<Polyhedron> cylinder(double radius, double height, int sides);

/// Distance of the corners of a regular polygon with the area of a circle from its centre, over the radius of the
/// circle [-]: an n-gon has the area n/2 R^2 sin(2 pi/n).
double circumradius_of_equal_area(int sides);

/// Radius of the ball, or of the disc of a planar scene (a prism of 64 sides about z), that a shape stands for: of the
/// same volume, or area; 0 = it stands for none [m].
/// @param volume  of the shape [m^3]
double round_radius_of(const Polyhedron& shape, bool is_planar, double volume);

}  // namespace riprap::geometry
