// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "riprap/geometry/surface/triangle_mesh.hpp"

namespace riprap::geometry {

/// Convex cells under the triangles of a surface: the solid that a surface bounds, as deep as `thickness`. The face of
/// a cell that is its triangle carries a field, all others are internal (ConvexView), so that a body that slides on the
/// surface meets no edge between two triangles (docs/theory/ground.md).
///
/// Neighbours share the wall under their common edge. With `down` the walls hold this direction, all cells are prisms
/// as deep as `thickness` along it, and the potential h/r of every cell is the depth along `down` over the thickness:
/// continuous over all walls, whatever the slope. Without, a wall halves the angle between its two triangles, where
/// both are equally deep, and the thickness counts across each triangle; where more than two meet in a sharp corner,
/// cells overlap or leave gaps that shrink with the square of the depth.
///
/// Under an open edge the wall stands across the triangle, or along `down`.
/// @param thickness  [m], > 0
/// @param down       direction of length 1; every triangle faces away from it
/// @returns one cell per triangle, in their order; empty where nothing is left of one (a ridge sharper than round-off).
std::vector<Polyhedron> cells_under(const TriangleMesh& mesh, double thickness, const std::optional<Vec3>& down);

/// Returns the cells of a planar scene: prisms from z = -1/2 to 1/2 under the segments of a line whose solid lies on
/// its right, as deep as `thickness` along -y. @param line  x increases from point to point
std::vector<Polyhedron> cells_under_line(const std::vector<Vec3>& line, double thickness);

}  // namespace riprap::geometry
