// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::test {

/// Bodies for tests of coupling, added one by one.
struct Scene {
    geometry::ShapeSet shapes;
    body::BodySet bodies;
    body::BodyState state;

    BodyId add(const geometry::Polyhedron& shape, const Pose& pose, body::Drive drive = body::Drive::free,
               double density = 1000) {
        return add_parts({{BodyId{}, shapes.add_convex(shape, bodies.is_planar), {}}}, pose, drive, density);
    }
    BodyId add_parts(std::vector<body::Part> parts, const Pose& pose, body::Drive drive = body::Drive::free,
                     double density = 1000) {
        body::NewBody body;
        body.name = "body" + std::to_string(bodies.size());
        body.density = density;
        body.drive = drive;
        body.pose = pose;
        body.parts = std::move(parts);
        return body::add_body(bodies, state, shapes, body);
    }
    BodyId add_half_space(const Vec3& normal, double offset) {
        return add_parts({{BodyId{}, shapes.add_half_space(normal, offset), {}}}, {}, body::Drive::fixed);
    }
};

/// Wendland's C2 kernel, W(0) alpha_d (1 - q/2)^4 (2 q + 1), q = r/h: written here a second time, so
/// that the fluid's own cannot agree with itself.
inline double wendland(double r, double h, int dimension) {
    const double q = r / h;
    if (q >= 2) {
        return 0;
    }
    const double pi = 3.14159265358979323846;
    const double scale = dimension == 2 ? 7 / (4 * pi * h * h) : 21 / (16 * pi * h * h * h);
    const double a = 1 - 0.5 * q;
    return scale * a * a * a * a * (2 * q + 1);
}

}  // namespace riprap::test
