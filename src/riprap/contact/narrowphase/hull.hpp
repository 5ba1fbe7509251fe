// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/vec3.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::contact {

/// An edge of a convex polyhedron: its two ends and the faces on both sides.
struct HullEdge {
    std::int32_t from, to;
    std::int32_t left, right;  ///< `left` runs from -> to, `right` runs to -> from
};

/// Surface of a convex polyhedron as contact searches use it, made from its half-edge structure once per shape:
/// deformation and motion do not change it.
struct HullTopology {
    std::vector<std::int32_t> face_start, face_vertex;     ///< loops, counter-clockwise seen from outside
    std::vector<std::int32_t> neighbour_start, neighbour;  ///< vertices beside a vertex
    std::vector<std::int32_t> fan_start, fan;              ///< faces around a vertex
    std::vector<HullEdge> edges;

    std::int32_t vertex_count() const { return static_cast<std::int32_t>(neighbour_start.size()) - 1; }
    std::int32_t face_count() const { return static_cast<std::int32_t>(face_start.size()) - 1; }
    std::span<const std::int32_t> loop(std::int32_t face) const { return part(face_start, face_vertex, face); }
    std::span<const std::int32_t> neighbours(std::int32_t v) const { return part(neighbour_start, neighbour, v); }
    std::span<const std::int32_t> faces_around(std::int32_t v) const { return part(fan_start, fan, v); }

 private:
    static std::span<const std::int32_t> part(const std::vector<std::int32_t>& start,
                                              const std::vector<std::int32_t>& values, std::int32_t i) {
        const auto k = static_cast<std::size_t>(i);
        return std::span(values).subspan(static_cast<std::size_t>(start[k]),
                                         static_cast<std::size_t>(start[k + 1] - start[k]));
    }
};

/// Topology of a closed convex polyhedron. The caller has audited the shape; a shape that is not closed is a broken
/// promise and throws InternalError.
HullTopology hull_topology(const geometry::Polyhedron& shape);

/// A convex polyhedron where it is now: corners and outward face normals in world axes. A half-space has no vertices,
/// one normal and an offset: { x : normal . x <= offset }.
struct PlacedHull {
    const HullTopology* topology;
    std::span<const Vec3> vertices;  ///< [m]
    std::span<const Vec3> normals;   ///< one per face [-]
    Vec3 centre;                     ///< a point inside [m]
    double offset{0};                ///< of a half-space [m]

    bool is_half_space() const { return vertices.empty(); }
};

/// Outward unit normals of all faces at the given corners.
void place_normals(const HullTopology& topology, std::span<const Vec3> vertices, std::span<Vec3> normals);

/// The vertex farthest along `direction`, the lower of two equal ones. Not for half-spaces.
inline std::int32_t support_vertex(const PlacedHull& hull, const Vec3& direction) {
    std::int32_t best = 0;
    double most = dot(direction, hull.vertices[0]);
    for (std::size_t i = 1; i < hull.vertices.size(); ++i) {
        const double along = dot(direction, hull.vertices[i]);
        if (along > most) {
            most = along;
            best = static_cast<std::int32_t>(i);
        }
    }
    return best;
}

}  // namespace riprap::contact
