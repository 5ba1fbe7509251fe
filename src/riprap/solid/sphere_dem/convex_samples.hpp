// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/body/multisphere.hpp"
#include "riprap/geometry/convex_view.hpp"

namespace riprap::solid::sphere_dem {

/// Radius of the samples of edges and corners over that of the samples of faces, R [-]. A body stands on the centres of
/// its outermost samples: one that is 6 R wide tips at a slope whose tangent is 0.005/3 less, 0.02 degrees at 14. That
/// radius is above the overlap at rest, so a corner slides from one flush block to the next with its centre above both.
inline constexpr double sharp_share = 0.005;

/// Returns small spheres in the edges and corners of a convex part, flush with its faces: in the plane one in each
/// corner of the section, in space along each edge, `spacing` apart at most; 2000 along an edge that is longer.
/// @param radius  of the spheres, less than the inscribed radius of the part [m]
std::vector<body::ShapeSphere> edge_samples(const geometry::ConvexView& shape, double radius, double spacing,
                                            bool is_planar);

/// Returns spheres in the faces of a convex part, flush with them and inside all others, two radii apart at most; none
/// in a face so narrow that no sphere fits. Those nearest to the edges carry no normal, as the edges of
/// body::box_shell.
/// @param radius  of the spheres, at most the inscribed radius of the part [m]
std::vector<body::ShapeSphere> face_samples(const geometry::ConvexView& shape, double radius, bool is_planar);

/// Estimates how many both are, for parts so large that they are better not made.
double sample_estimate(const geometry::ConvexView& shape, double radius);

}  // namespace riprap::solid::sphere_dem
