// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/mat3.hpp"
#include "riprap/core/quat.hpp"

namespace riprap::geometry {

/// A polyhedron as vertices and faces; the common currency of builders, readers, hulls and cutters. Faces wind
/// counter-clockwise seen from outside. Nothing is promised until `audit` (surface_audit.hpp) or
/// `make_convex` has looked at it.
struct Polyhedron {
    std::vector<Vec3> vertices;                    ///< [m]
    std::vector<std::vector<std::int32_t>> faces;  ///< vertex loops
    /// Faces that bound a convex part but carry no field (see ConvexView); empty = none, else one per face.
    std::vector<std::uint8_t> is_internal;
};

/// The half-space { x : normal . x <= offset }, normal of length 1 pointing out of the body, offset [m].
struct Plane {
    Vec3 normal;
    double offset;
};

/// Volume [m^3], centroid [m] and second moments about the centroid of the volume inside a closed surface.
struct MassProperties {
    double volume;       ///< [m^3]
    Vec3 centroid;       ///< [m]
    Mat3 second_moment;  ///< integral of x x^T dV about the centroid [m^5]
};

/// Exact integrals over tetrahedra that join a triangulation of the surface to one point o:
/// integral of x x^T dV over a tetrahedron (o,a,b,c) of volume V, o at the origin, is V/20 (s s^T + a a^T + b b^T + c
/// c^T), s = a + b + c [Zhao, 4]. Works for any closed oriented polyhedron with plane faces, convex or not; tetrahedra
/// on the far side of o count as negative. The second moments are summed about the centroid itself, so a shape far from
/// the origin loses no digits in them. An inside-out surface has negative volume; a flat one has volume 0 and the mean
/// of its vertices as centroid.
MassProperties mass_properties(const Polyhedron& polyhedron);

/// Inertia tensor per unit density, tr(S) I - S, from second moments S [m^5].
Mat3 inertia_from_second_moment(const Mat3& second_moment);

/// Vector area of a vertex loop, 1/2 sum of x_i x x_(i+1) about its first vertex [m^2] [Tampieri1992]: along the
/// outward normal, as long as the area of the loop. Exact for plane loops, the least-squares choice for bent ones.
Vec3 vector_area(std::span<const Vec3> vertices, std::span<const std::int32_t> loop);

/// Plane of a face: direction of its vector area, offset the mean over its vertices.
/// The caller guarantees a non-zero area.
Plane face_plane(std::span<const Vec3> vertices, std::span<const std::int32_t> loop);

/// Largest extent of the bounding box [m]: the length that geometric tolerances are scaled by.
double length_scale(std::span<const Vec3> vertices);

/// Places a shape at `pose`.
Polyhedron moved(const Polyhedron& polyhedron, const Pose& pose);

}  // namespace riprap::geometry
