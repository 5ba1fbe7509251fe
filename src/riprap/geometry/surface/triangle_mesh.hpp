// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

struct Surface;

/// A surface of triangles, open or closed. Corners wind counter-clockwise seen from outside of the solid.
struct TriangleMesh {
    std::vector<Vec3> points;                          ///< [m]
    std::vector<std::array<std::int32_t, 3>> corners;  ///< of each triangle, numbers of points
    std::vector<std::int32_t> faces{};                 ///< of each, the face of the file that it is of; may be empty

    std::int32_t size() const { return static_cast<std::int32_t>(corners.size()); }
    const Vec3& corner(std::int32_t triangle, int k) const {
        return points[static_cast<std::size_t>(
            corners[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(k)])];
    }
    /// Twice the area of a triangle along its outward normal [m^2].
    Vec3 area_normal(std::int32_t triangle) const {
        const Vec3& a = corner(triangle, 0);
        return cross(corner(triangle, 1) - a, corner(triangle, 2) - a);
    }
};

/// Triangles of a surface as read from a file: points nearer than `tolerance` are one, polygons are parted
/// into triangles (fan.hpp), and those without area are left out. @param tolerance  as a share of the extent of the
/// surface [-]
TriangleMesh mesh_of(const Surface& surface, double tolerance = 1e-9);

/// Joins points that are equal but for round-off and leaves out triangles that have lost their area.
TriangleMesh welded(const TriangleMesh& mesh, double tolerance);

/// The direction that most of the surface faces: that of its vector area; along z where the surface is closed.
Vec3 main_direction(const TriangleMesh& mesh);

}  // namespace riprap::geometry
