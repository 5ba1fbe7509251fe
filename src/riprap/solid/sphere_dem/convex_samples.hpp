// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/geometry/polyhedra/convex_view.hpp"
#include "riprap/solid/sphere_dem/surface_sample.hpp"

namespace riprap::solid::sphere_dem {

/// Radius of the samples of edges and corners over that of the samples of faces, R [-]. A body stands on the centres of
/// its outermost samples: one that is 6 R wide tips at a slope whose tangent is 0.005/3 less, 0.02 degrees at 14. That
/// radius is above the overlap at rest, so a corner slides from one flush block to the next with its centre above both.
inline constexpr double sharp_share = 0.005;

/// Returns small spheres in the edges and corners of a convex part, flush with its faces: in the plane one in each
/// corner of the section, in space along each edge, two R apart at most; 2000 along an edge that is longer. Each stands
/// for a strip of the faces beside it, R wide; in the plane for half of the way to the next sample.
/// @param radius      of the spheres, less than the inscribed radius of the part [m]
/// @param law_radius  R of the samples of faces [m]
std::vector<SurfaceSample> edge_samples(const geometry::ConvexView& shape, double radius, double law_radius,
                                        bool is_planar);

/// Returns spheres in the faces of a convex part, flush with them and inside all others, two radii apart at most; none
/// in a face so narrow that no sphere fits. In the plane they lie at equal parts of each side, whose ends are corners.
/// @param radius           of the spheres, at most the inscribed radius of the part [m]
/// @param meets_triangles  some lie near the edges, for triangles: they carry no normal, as those of body::box_shell
std::vector<SurfaceSample> face_samples(const geometry::ConvexView& shape, double radius, bool is_planar,
                                        bool meets_triangles);

/// Estimates how many both are, for parts so large that they are better not made.
double sample_estimate(const geometry::ConvexView& shape, double radius);

}  // namespace riprap::solid::sphere_dem
