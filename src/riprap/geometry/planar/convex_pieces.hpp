// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/geometry/planar/planar_polygon.hpp"

namespace riprap::geometry {

/// Divides a simple polygon into convex ones that meet in whole edges and have no corners of their own: triangles, cut
/// off the corner whose least angle is largest first, then joined across diagonals wherever the two together are convex
/// [Hertel1983]. A convex polygon is its only piece. Empty when the polygon runs clockwise or has no area.
std::vector<Polygon> convex_pieces(const Polygon& polygon);

}  // namespace riprap::geometry
