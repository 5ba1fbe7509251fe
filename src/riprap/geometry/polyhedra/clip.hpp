// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// A vertex closer to the cutting plane than this fraction of length_scale lies on it: it then belongs to both pieces
/// and no new vertex is made beside it, so that no piece is thinner than this.
inline constexpr double cut_tolerance = 1e-12;

/// The two pieces of a convex polyhedron cut by a plane. A side on which there is nothing is an empty polyhedron;
/// otherwise both have the cut as their last face, wound outward.
struct CutPieces {
    Polyhedron below;  ///< where normal . x <= offset
    Polyhedron above;  ///< where normal . x >= offset

    bool is_cut() const { return !below.faces.empty() && !above.faces.empty(); }
};

/// Cuts a convex polyhedron by a plane. Whether a vertex lies below, on or above is decided once per vertex, and each
/// edge is cut once, so both pieces are closed whatever round-off does, and share the corners of the cut bit by bit:
/// the volumes add up to that of the whole to round-off. Faces keep their order and their internal flag; the cut is
/// not internal. A polyhedron that only touches the plane is returned whole on its side.
/// The caller guarantees a closed, convex, outward-wound polyhedron and a normal of length 1.
CutPieces cut_convex(const Polyhedron& polyhedron, const Plane& plane);

/// The part of a convex polyhedron inside the half-space of `plane`; empty when there is none.
Polyhedron clip_convex(const Polyhedron& polyhedron, const Plane& plane);

/// Lowest and highest normal . x over the vertices [m]; the polyhedron has at least one.
struct Range {
    double low, high;
};
Range range_along(const Polyhedron& polyhedron, const Vec3& normal);

}  // namespace riprap::geometry
