// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// Repairs that an audit may make, and its tolerances. Every repair is reported in the notes of the result.
struct SurfaceAuditOptions {
    /// Vertices closer than this fraction of the diagonal of the bounding box are one; also how far a face may be from
    /// flat, a part from convex, and how thin a face or a part may get [-]. 1e-6 is ten times the round-off of the
    /// single precision of STL files.
    double weld_tolerance{1e-6};
    bool fix_orientation{false};  ///< turn faces and shells that wind inwards instead of refusing them
    bool drop_collapsed{false};   ///< leave out faces whose corners weld to fewer than three
    /// All shells are convex parts of one body: where two parts share a whole face, both faces are flagged internal;
    /// where they share only a part of a face the surface is refused, because half a face cannot be internal. False:
    /// each shell is a body of its own, nothing is flagged.
    bool is_one_body{true};
};

/// A closed convex shell of a surface.
struct SurfacePart {
    Polyhedron polyhedron;  ///< coplanar neighbours joined to polygons, wound outward
    std::string name;       ///< of the solid, object or group, in quotes; may be empty
    double volume;          ///< [m^3]
};

/// Largest number of faces of one convex part after joining coplanar ones, and of parts.
inline constexpr std::size_t audit_faces_of_a_part = 5'000;
inline constexpr std::size_t audit_parts = 10'000;

}  // namespace riprap::geometry
