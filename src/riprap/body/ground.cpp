// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/ground.hpp"

#include <cmath>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"

namespace riprap::body {

namespace {

/// The one face of a part that carries a field; -1 where none or several do.
std::int32_t only_face(const geometry::ConvexView& view) {
    std::int32_t found = -1;
    for (std::int32_t f = 0; f < view.face_count; ++f) {
        if (view.is_internal[f] == 0) {
            if (found >= 0) {
                return -1;
            }
            found = f;
        }
    }
    return found;
}

}  // namespace

bool is_ground(const BodySet& bodies, const geometry::ShapeSet& shapes, BodyId body) {
    const auto b = at(body.value);
    if (may_move(bodies, b)) {
        return false;
    }
    for (std::int32_t p = bodies.part_begin[b]; p < bodies.part_begin[b + 1]; ++p) {
        const ShapeId shape = bodies.parts[at(p)].shape;
        if (shapes.is_half_space(shape) || only_face(shapes.view(shape)) < 0) {
            return false;
        }
    }
    return bodies.part_begin[b] < bodies.part_begin[b + 1];
}

geometry::TriangleMesh ground_mesh(const BodySet& bodies, const geometry::ShapeSet& shapes, BodyId body) {
    geometry::TriangleMesh mesh;
    double extent = 0;
    for (std::int32_t p = bodies.part_begin[at(body.value)]; p < bodies.part_begin[at(body.value) + 1]; ++p) {
        const Part& part = bodies.parts[at(p)];
        const geometry::ConvexView view = shapes.view(part.shape);
        const std::int32_t face = only_face(view);
        const auto first = static_cast<std::int32_t>(mesh.points.size());
        const std::int32_t begin = view.face_start[face], count = view.face_start[face + 1] - begin;
        for (std::int32_t k = 0; k < count; ++k) {
            mesh.points.push_back(to_world(part.local, view.vertex(view.face_vertex[begin + k])));
        }
        for (std::int32_t k = 2; k < count; ++k) {
            mesh.corners.push_back({first, first + k - 1, first + k});
        }
        extent = std::max(extent, norm(part.local.position) + view.circumradius);
    }
    constexpr double same_point = 1e-9;  // of the extent: corners of neighbours differ by round-off
    return geometry::welded(mesh, same_point * extent);
}

geometry::TriangleField ground_field(const BodySet& bodies, const geometry::ShapeSet& shapes, BodyId body) {
    geometry::TriangleMesh mesh = ground_mesh(bodies, shapes, body);
    const Vec3 up = geometry::main_direction(mesh);
    return {std::move(mesh), bodies.is_planar && std::abs(up.z) > 0.5 ? Vec3{0, 1, 0} : up};
}

std::vector<Ground> find_grounds(const BodySet& bodies, const geometry::ShapeSet& shapes) {
    std::vector<Ground> grounds;
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        if (is_ground(bodies, shapes, BodyId{b})) {
            grounds.push_back({BodyId{b}, ground_field(bodies, shapes, BodyId{b})});
        }
    }
    return grounds;
}

}  // namespace riprap::body
