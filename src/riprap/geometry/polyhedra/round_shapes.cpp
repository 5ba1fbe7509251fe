// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/round_shapes.hpp"

#include <algorithm>
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

double round_radius_of(const Polyhedron& shape, bool is_planar, double volume) {
    if (!is_planar) {
        return is_sphere(shape) ? std::cbrt(0.75 * std::numbers::inv_pi * volume) : 0;
    }
    constexpr std::size_t corners = 128;  // of both ends
    if (shape.vertices.size() != corners) {
        return 0;
    }
    const double radius = std::hypot(shape.vertices[0].x, shape.vertices[0].y);
    const auto is_on_circle = [radius](const Vec3& x) {
        return std::abs(std::hypot(x.x, x.y) - radius) < 1e-6 * radius;  // as corners of sphere()
    };
    return std::ranges::all_of(shape.vertices, is_on_circle)
               ? radius / circumradius_of_equal_area(static_cast<int>(corners / 2))
               : 0;
}

}  // namespace riprap::geometry
