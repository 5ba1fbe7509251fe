// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/polyhedron.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::geometry {

namespace {

/// a b - c d to within 1.5 units in the last place of the result [Jeannerod2013].
double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d;
    const double error = std::fma(-c, d, cd);
    return std::fma(a, b, -cd) + error;
}

/// a x b, every component to full relative precision. The edges of a turned needle are nearly parallel, and a plain
/// cross product would tilt its long faces by 1e-16 over the slenderness.
Vec3 precise_cross(const Vec3& a, const Vec3& b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

/// Calls visit(a, b, c, determinant) for each triangle of the fanned surface, relative to `o`;
/// determinant = a . (b x c) is six times the signed volume of (o,a,b,c).
template <class Visit>
void for_each_tetrahedron(const Polyhedron& polyhedron, const Vec3& o, Visit&& visit) {
    const auto corner = [&](std::int32_t i) { return polyhedron.vertices[static_cast<std::size_t>(i)] - o; };
    for (const std::vector<std::int32_t>& loop : polyhedron.faces) {
        for (std::size_t k = 2; k < loop.size(); ++k) {
            const Vec3 a = corner(loop[0]), b = corner(loop[k - 1]), c = corner(loop[k]);
            visit(a, b, c, dot(a, precise_cross(b, c)));
        }
    }
}

Vec3 mean(std::span<const Vec3> points) {
    Vec3 sum{};
    for (const Vec3& x : points) {
        sum += x;
    }
    return points.empty() ? sum : sum / static_cast<double>(points.size());
}

}  // namespace

MassProperties mass_properties(const Polyhedron& polyhedron) {
    const Vec3 o = mean(polyhedron.vertices);
    double six_volumes = 0;
    Vec3 first{};  // 24 times the first moment about o
    for_each_tetrahedron(polyhedron, o, [&](const Vec3& a, const Vec3& b, const Vec3& c, double determinant) {
        six_volumes += determinant;
        first += determinant * (a + b + c);
    });
    MassProperties result{six_volumes / 6, o, {}};
    if (six_volumes == 0) {
        return result;
    }
    result.centroid = o + first / (4 * six_volumes);

    Mat3 second{};  // 120 times the second moment about the centroid
    for_each_tetrahedron(polyhedron, result.centroid,
                         [&](const Vec3& a, const Vec3& b, const Vec3& c, double determinant) {
                             const Vec3 s = a + b + c;
                             second = second + determinant * (outer(s, s) + outer(a, a) + outer(b, b) + outer(c, c));
                         });
    for (int i = 0; i < 3; ++i) {
        result.second_moment.row[i] = second.row[i] / 120.0;
    }
    return result;
}

Mat3 inertia_from_second_moment(const Mat3& second_moment) {
    const double t = trace(second_moment);
    return Mat3::diagonal({t, t, t}) - second_moment;
}

Vec3 vector_area(std::span<const Vec3> vertices, std::span<const std::int32_t> loop) {
    Vec3 twice{};
    if (loop.empty()) {
        return twice;
    }
    const Vec3& o = vertices[static_cast<std::size_t>(loop[0])];
    for (std::size_t k = 2; k < loop.size(); ++k) {
        twice += precise_cross(vertices[static_cast<std::size_t>(loop[k - 1])] - o,
                               vertices[static_cast<std::size_t>(loop[k])] - o);
    }
    return 0.5 * twice;
}

Plane face_plane(std::span<const Vec3> vertices, std::span<const std::int32_t> loop) {
    const Vec3 normal = normalized(vector_area(vertices, loop));
    double sum = 0;
    for (const std::int32_t i : loop) {
        sum += dot(normal, vertices[static_cast<std::size_t>(i)]);
    }
    return {normal, sum / static_cast<double>(loop.size())};
}

double length_scale(std::span<const Vec3> vertices) {
    if (vertices.empty()) {
        return 0;
    }
    Vec3 low = vertices[0], high = vertices[0];
    for (const Vec3& x : vertices) {
        low = min(low, x);
        high = max(high, x);
    }
    const Vec3 extent = high - low;
    return std::max({extent.x, extent.y, extent.z});
}

Polyhedron moved(const Polyhedron& polyhedron, const Pose& pose) {
    Polyhedron result = polyhedron;
    for (Vec3& x : result.vertices) {
        x = to_world(pose, x);
    }
    return result;
}

}  // namespace riprap::geometry
