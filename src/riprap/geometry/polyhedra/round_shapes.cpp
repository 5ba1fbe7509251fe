// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/round_shapes.hpp"

#include <cmath>
#include <numbers>

namespace riprap::geometry {

Polyhedron ellipsoid(const Vec3& semi_axes) {
    Polyhedron shape = sphere(1);
    for (Vec3& v : shape.vertices) {
        v = {v.x * semi_axes.x, v.y * semi_axes.y, v.z * semi_axes.z};
    }
    return shape;
}

double circumradius_of_equal_area(int sides) {
    return std::sqrt(2 * std::numbers::pi / (sides * std::sin(2 * std::numbers::pi / sides)));
}

Outcome<Polyhedron> cylinder(double radius, double height, int sides) {
    return prism(sides, radius * circumradius_of_equal_area(sides), height);
}

}  // namespace riprap::geometry
