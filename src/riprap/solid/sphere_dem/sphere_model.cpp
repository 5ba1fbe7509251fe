// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/sphere_model.hpp"

#include "riprap/core/index.hpp"

namespace riprap::solid::sphere_dem {

void SphereSet::add(BodyId of, double sphere_radius, const Vec3& centre, const Vec3& normal) {
    body.push_back(of.value);
    radius.push_back(sphere_radius);
    local.push_back(centre);
    face_normal.push_back(normal);
}

void SphereSet::finish(std::int32_t body_count) {
    begin.assign(at(body_count) + 1, 0);
    for (const std::int32_t b : body) {
        ++begin[at(b) + 1];
    }
    for (std::size_t b = 0; b < at(body_count); ++b) {
        begin[b + 1] += begin[b];
    }
}

void TriangleSet::add(BodyId of, const std::vector<Vec3>& points, const std::vector<std::int32_t>& corner_indices) {
    for (std::size_t k = 0; k < corner_indices.size(); ++k) {
        if (k % 3 == 0) {
            body.push_back(of.value);
        }
        corners.push_back(points[at(corner_indices[k])]);
        vertices.push_back(vertex_count_ + corner_indices[k]);
    }
    vertex_count_ += static_cast<std::int32_t>(points.size());
}

}  // namespace riprap::solid::sphere_dem
