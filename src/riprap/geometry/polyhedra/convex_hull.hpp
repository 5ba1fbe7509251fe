// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "riprap/geometry/polyhedra/outcome.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// More points than this are refused, so that no input file can keep the hull busy for minutes.
inline constexpr std::size_t hull_point_limit = 1'000'000;

/// Convex hull of points, through Qhull [Barber1996], with coplanar facets merged to polygons. Points inside the hull,
/// inside its faces or edges, and all but one of points closer than 1e-9 of the extent have no part in it.
/// Refused: points that are not finite, more than hull_point_limit, fewer than four, all in one place, on one line or
/// in one plane (to 1e-9 of the extent). The result passes half_edges() and is convex to 1e-9 of the extent.
Outcome<Polyhedron> convex_hull(std::span<const Vec3> points);

/// A random block for packs: the hull of `corner_count` points spread uniformly over a sphere about the origin, drawn
/// again until the concentric sphere of a tenth of the radius fits inside. The same seed gives the same block
/// everywhere.
/// @param corner_count  4 to 200
/// @param circumradius  radius of the sphere, which holds every corner [m]
Outcome<Polyhedron> random_hull(std::uint64_t seed, int corner_count, double circumradius);

}  // namespace riprap::geometry
