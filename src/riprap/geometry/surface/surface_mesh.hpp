// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "riprap/core/vec3.hpp"
#include "riprap/geometry/surface/surface.hpp"
#include "riprap/geometry/surface/surface_part.hpp"
#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

/// A surface under audit: welded points, faces as loops of points, and where each face came from.
struct SurfaceMesh {
    const Surface* source;
    double tolerance;  ///< weld tolerance [m]
    std::vector<Vec3> points;
    std::vector<std::vector<std::int32_t>> faces;
    std::vector<std::int32_t> origin;  ///< per face: its number in the source

    std::size_t source_face(std::size_t f) const { return static_cast<std::size_t>(origin[f]); }
    SourcePlace place_of(std::size_t f) const { return source->place_of(source_face(f)); }
    std::string name_of(std::size_t f) const { return source->name_of(source_face(f)); }
    std::int32_t body_of(std::size_t f) const { return source->face_body[source_face(f)]; }
    const Vec3& point(std::int32_t p) const { return points[static_cast<std::size_t>(p)]; }
};

/// "(x, y, z)" in metres, for messages.
std::string coordinates(const Vec3& x);

/// Stage 1 of audit_surface: welds points, joins equal faces, and reports faces that are no flat polygons with an area.
SurfaceMesh weld_surface(const Surface& surface, const SurfaceAuditOptions& options, ProblemList& problems,
                         std::vector<Diagnostic>& notes);

/// Closed shells as lists of faces, each with the half-edge on the other side of every edge.
struct ShellSet {
    std::vector<std::int32_t> half_edge_start;  ///< per face, first of its half-edges; half-edge k leaves corner k
    std::vector<std::int32_t> half_edge_face;
    std::vector<std::int32_t> twin;  ///< per half-edge
    std::vector<std::vector<std::int32_t>> shells;
};

/// Stage 2 of audit_surface: pairs faces over edges and checks their winding; turns faces of `mesh` where asked to.
/// With problems found the shells are empty.
ShellSet find_shells(SurfaceMesh& mesh, const SurfaceAuditOptions& options, ProblemList& problems,
                     std::vector<Diagnostic>& notes);

/// A convex part with the welded point that each of its vertices is.
struct ConvexPart {
    SurfacePart part;
    std::vector<std::int32_t> point;  ///< per vertex
};

/// Stage 3: joins coplanar neighbours of one shell and checks that it encloses a convex volume; empty part if not.
ConvexPart make_convex_part(const SurfaceMesh& mesh, const ShellSet& shells, std::size_t shell, ProblemList& problems);

/// Stage 4: reports parts that overlap and, for one body, flags shared faces and reports partly shared ones.
void check_part_contacts(std::vector<ConvexPart>& parts, const SurfaceMesh& mesh, const SurfaceAuditOptions& options,
                         ProblemList& problems);

}  // namespace riprap::geometry
