// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/geometry/planar/planar_vector.hpp"
#include "riprap/geometry/polyhedra/outcome.hpp"

namespace riprap::geometry {

/// A simple polygon, convex or concave: corners counter-clockwise, the last one joined to the first [m].
using Polygon = std::vector<Vec2>;

/// Area, centroid and second moments about the centroid.
struct PolygonMoments {
    double area{0};   ///< S [m^2]
    Vec2 centroid{};  ///< [m]
    double xx{0};     ///< integral of (x - x_c)^2 over the area [m^4]
    double yy{0};     ///< of (y - y_c)^2 [m^4]
    double xy{0};     ///< of (x - x_c)(y - y_c) [m^4]
};

/// Integrates 1, x, y, x^2, y^2 and x y over a polygon by sums over the triangles that its edges span with a corner
/// (simplex integration), exact for any simple polygon:
///
///     S = 1/2 sum a_k,  S_x = 1/6 sum a_k (x_k + x_k+1),  S_xx = 1/12 sum a_k (x_k^2 + x_k x_k+1 + x_k+1^2),
///     S_xy = 1/24 sum a_k (2 x_k y_k + x_k y_k+1 + x_k+1 y_k + 2 x_k+1 y_k+1),  a_k = x_k y_k+1 - x_k+1 y_k
///
/// with coordinates from the first corner, so that a polygon far from the origin loses no digits. A polygon that runs
/// clockwise has a negative area.
PolygonMoments moments_of(std::span<const Vec2> corners);

/// Tells whether `point` lies inside or on the outline.
bool is_inside(std::span<const Vec2> corners, const Vec2& point);

/// Makes a polygon of corners in either sense of turn, without repeated corners, or refuses it: fewer than three
/// corners, a number that is not finite, edges that cross or touch, an area below `sliver` times the square of the
/// longest extent [-].
Outcome<Polygon> make_polygon(std::span<const Vec2> corners, double sliver = 1e-6);

}  // namespace riprap::geometry
