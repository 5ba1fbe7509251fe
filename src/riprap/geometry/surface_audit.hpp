// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/geometry/polyhedron.hpp"
#include "riprap/geometry/surface.hpp"

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

/// Either parts or problems, never both.
struct SurfaceAudit {
    std::vector<SurfacePart> parts;
    std::vector<Diagnostic> problems;  ///< why the surface is refused, each with its place
    std::vector<Diagnostic> notes;     ///< what was repaired or is odd, to be shown to the user
};

/// Largest number of faces of one convex part after joining coplanar ones, and of parts.
inline constexpr std::size_t audit_faces_of_a_part = 5'000;
inline constexpr std::size_t audit_parts = 10'000;

/// Turns polygons into closed convex parts or says why not. In this order, all problems of a stage at once:
///
/// 1. equal vertices are welded and equal faces joined; collapsed and zero-area faces, bent polygons, and a surface
///    that is flat as a whole are problems;
/// 2. each edge must have one face on either side, with opposite directions: open edges, edges of three or more faces
///    that do not bound separate solids, and faces that wind inwards are problems. Where an edge has four or more faces
///    because solids touch there, faces are paired across the solid wedges between them;
/// 3. faces connected over edges are shells; coplanar neighbours are joined; a shell must enclose a volume and be
///    convex, otherwise its worst edge is named: a body that is not convex is stated as several closed convex shells;
/// 4. no two parts may overlap or contain each other; shared faces are flagged (see SurfaceAuditOptions::is_one_body).
SurfaceAudit audit_surface(const Surface& surface, const SurfaceAuditOptions& options = {});

/// Stages 1 and 2 alone: checks that a surface of any shape is closed and wound outwards. Returns why it is not.
/// @param notes  gets what was repaired or is odd
std::vector<Diagnostic> audit_closed_surface(const Surface& surface, const SurfaceAuditOptions& options,
                                             std::vector<Diagnostic>& notes);

}  // namespace riprap::geometry
