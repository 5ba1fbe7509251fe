// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/geometry/polyhedra/convex_view.hpp"

// Questions about one convex shape and one point or direction, in the frame of the shape. Plain functions of a view,
// for host and device.

namespace riprap::geometry {

/// h(x) = min_j h_j(x), the depth of x below the nearest face plane [m]: inside, exactly the distance to the surface;
/// outside, minus a lower bound of it. `face` (where not null) receives the nearest face, the lower of two equal ones.
RIPRAP_HD inline double depth_below_faces(const ConvexView& shape, const Vec3& x, std::int32_t* face = nullptr) {
    std::int32_t nearest = 0;
    double least = shape.offset[0] - dot(shape.normal(0), x);
    for (std::int32_t j = 1; j < shape.face_count; ++j) {
        const double h = shape.offset[j] - dot(shape.normal(j), x);
        if (h < least) {
            least = h;
            nearest = j;
        }
    }
    if (face != nullptr) {
        *face = nearest;
    }
    return least;
}

/// True for points inside, on the surface, or outside by no more than `margin` from every face plane [m].
RIPRAP_HD inline bool contains(const ConvexView& shape, const Vec3& x, double margin = 0) {
    for (std::int32_t j = 0; j < shape.face_count; ++j) {
        if (shape.offset[j] - dot(shape.normal(j), x) < -margin) {
            return false;
        }
    }
    return true;
}

/// The vertex farthest along `direction` (of any length), the lower of two equal ones. Not for half-spaces.
RIPRAP_HD inline std::int32_t support_vertex(const ConvexView& shape, const Vec3& direction) {
    std::int32_t best = 0;
    double most = dot(direction, shape.vertex(0));
    for (std::int32_t i = 1; i < shape.vertex_count; ++i) {
        const double along = dot(direction, shape.vertex(i));
        if (along > most) {
            most = along;
            best = i;
        }
    }
    return best;
}

/// The point of a surface nearest to a given point.
struct SurfacePoint {
    Vec3 point;         ///< [m]
    Vec3 normal;        ///< unit vector out of the body there: from `point` to a point outside, else that of `face` [-]
    double distance;    ///< to the given point, positive outside, negative inside [m]
    std::int32_t face;  ///< a face that `point` lies on
};

/// Nearest point to x on a face polygon: its foot on the plane if that falls inside the loop, else on the nearest edge.
RIPRAP_HD inline Vec3 nearest_on_face(const ConvexView& shape, std::int32_t face, const Vec3& x) {
    const Vec3 n = shape.normal(face);
    const Vec3 foot = x + (shape.offset[face] - dot(n, x)) * n;
    const std::int32_t begin = shape.face_start[face], end = shape.face_start[face + 1];
    bool is_inside = true;
    Vec3 best = foot;
    double least = 0;
    for (std::int32_t k = begin; k < end; ++k) {
        const Vec3 a = shape.vertex(shape.face_vertex[k]);
        const Vec3 b = shape.vertex(shape.face_vertex[k + 1 < end ? k + 1 : begin]);
        const Vec3 edge = b - a;
        if (dot(cross(n, edge), foot - a) >= 0) {
            continue;  // the foot is on the inner side of this edge
        }
        const double t = dot(foot - a, edge) / norm_squared(edge);
        const Vec3 on_edge = a + (t < 0 ? 0.0 : t > 1 ? 1.0 : t) * edge;
        const double squared = norm_squared(on_edge - foot);
        if (is_inside || squared < least) {
            is_inside = false;
            least = squared;
            best = on_edge;
        }
    }
    return best;
}

/// Nearest point of the surface, exact: inside, the foot on the nearest face; outside, the nearest over the faces that
/// see x. Also for half-spaces. About one pass over the faces and edges of the shape.
RIPRAP_HD inline SurfacePoint closest_surface_point(const ConvexView& shape, const Vec3& x) {
    std::int32_t face = 0;
    const double depth = depth_below_faces(shape, x, &face);
    if (depth >= 0 || shape.vertex_count == 0) {
        const Vec3 n = shape.normal(face);
        return {x + depth * n, n, -depth, face};
    }
    SurfacePoint result{};
    double least = -1;
    for (std::int32_t j = 0; j < shape.face_count; ++j) {
        if (shape.offset[j] - dot(shape.normal(j), x) >= 0) {
            continue;
        }
        const Vec3 point = nearest_on_face(shape, j, x);
        const double squared = norm_squared(x - point);
        if (least < 0 || squared < least) {
            least = squared;
            result.point = point;
            result.face = j;
        }
    }
    result.distance = std::sqrt(least);
    result.normal = result.distance > 0 ? (x - result.point) / result.distance : shape.normal(result.face);
    return result;
}

}  // namespace riprap::geometry
