// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "riprap/geometry/polyhedra/outcome.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// Extents between which the integrals over a solid, up to its fifth power, are normal doubles [m].
inline constexpr double least_extent = 1e-60, most_extent = 1e60;

/// Share of the largest extent that is thick enough for any solid here. Thinner ones are refused only where the merging
/// of coplanar faces, which is good to 1e-9, leaves nothing of them.
inline constexpr double safe_slenderness = 1e-6;

/// Tells why double precision cannot hold a closed convex part: its extent is out of range, or it is so thin that its
/// faces merge into one plane. Returns nothing where ShapeSet::add_convex can take it.
/// @param is_planar  the part is a prism one metre high along z, which does not count
std::optional<GeometryProblem> part_problem(const Polyhedron& part, bool is_planar);

/// The problem of a solid of such extents that double precision cannot hold, and the extents that it can.
GeometryProblem extent_problem(const Vec3& extents, bool is_planar);

}  // namespace riprap::geometry
