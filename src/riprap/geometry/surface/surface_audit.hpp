// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/geometry/surface/surface.hpp"
#include "riprap/geometry/surface/surface_part.hpp"

namespace riprap::geometry {

/// Either parts or problems, never both.
struct SurfaceAudit {
    std::vector<SurfacePart> parts;
    std::vector<Diagnostic> problems;  ///< why the surface is refused, each with its place
    std::vector<Diagnostic> notes;     ///< what was repaired or is odd, to be shown to the user
};

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
