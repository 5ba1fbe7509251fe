// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/core/mat3.hpp"

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

/// Volume [m^3], centroid [m] and second moments about the centroid of the volume inside a closed surface.
struct MassProperties {
    double volume;       ///< [m^3]
    Vec3 centroid;       ///< [m]
    Mat3 second_moment;  ///< integral of x x^T dV about the centroid [m^5]
};

/// Exact integrals over tetrahedra from one vertex:
/// integral of x x^T dV over a tetrahedron (o,a,b,c) of volume V, o at the origin, is V/20 (s s^T + a a^T + b b^T + c
/// c^T), s = a + b + c. Works for any closed oriented polyhedron, convex or not.
MassProperties mass_properties(const Polyhedron& polyhedron);

/// Inertia tensor per unit density, tr(S) I - S, from second moments S [m^5].
Mat3 inertia_from_second_moment(const Mat3& second_moment);

}  // namespace riprap::geometry
