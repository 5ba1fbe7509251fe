// SPDX-License-Identifier: Apache-2.0
#include "few_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace selftest {

using riprap::Vec3;

FlatShape::FlatShape(const std::vector<Vec3>& vertices, const std::vector<std::vector<std::int32_t>>& faces,
                     double radius)
    : inscribed_radius(radius) {
    for (const Vec3& v : vertices) {
        vertex_x.push_back(v.x);
        vertex_y.push_back(v.y);
        vertex_z.push_back(v.z);
        circumradius = std::max(circumradius, norm(v));
    }
    for (const std::vector<std::int32_t>& face : faces) {
        const auto corner = [&](std::size_t i) { return vertices[static_cast<std::size_t>(face[i])]; };
        const Vec3 n = normalized(cross(corner(1) - corner(0), corner(2) - corner(0)));
        const double d = dot(n, corner(0));
        double depth = 0;
        for (const Vec3& v : vertices) {
            depth = std::max(depth, d - dot(n, v));
        }
        normal_x.push_back(n.x);
        normal_y.push_back(n.y);
        normal_z.push_back(n.z);
        offset.push_back(d);
        fdem_weight.push_back(1 / depth);
        is_internal.push_back(0);
        face_vertex.insert(face_vertex.end(), face.begin(), face.end());
        face_start.push_back(static_cast<std::int32_t>(face_vertex.size()));
    }
}

std::vector<FlatShape> few_shapes() {
    const double a = 0.6, b = 0.45, c = 0.35;
    const FlatShape cuboid(
        {{-a, -b, -c}, {a, -b, -c}, {a, b, -c}, {-a, b, -c}, {-a, -b, c}, {a, -b, c}, {a, b, c}, {-a, b, c}},
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}, c);

    const double t = 0.5;  // half the edge of the cube around the tetrahedron; r = t / sqrt(3)
    const FlatShape tetrahedron({{t, t, t}, {t, -t, -t}, {-t, t, -t}, {-t, -t, t}},
                                {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}, t / std::sqrt(3.0));

    const double r = 0.4, h = 0.5;  // the triangle's inscribed circle is smaller than the half height
    const double s = r * std::sqrt(3.0);
    const FlatShape prism({{2 * r, 0, -h}, {-r, s, -h}, {-r, -s, -h}, {2 * r, 0, h}, {-r, s, h}, {-r, -s, h}},
                          {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}, r);
    return {cuboid, tetrahedron, prism};
}

}  // namespace selftest
