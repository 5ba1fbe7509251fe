// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// Moves the corners of polygons, which a file in single precision or with few digits leaves beside their planes, into
/// them. Each corner x goes the least way d to the planes n_f . x = c_f of its faces with more than three corners,
///
///     (sum n_f n_f^T + e I) d = sum n_f (c_f - n_f . x),    e = 1e-8,
///
/// a few times, planes being fitted anew in between (face_plane). Triangles follow their corners. Where all polygons
/// are plane to half of what merging faces and convexity take (1e-9 of the extent), nothing is moved. Corners of more
/// than three polygons may have no such place; the caller looks at what is left (part_problem).
/// @returns the longest way that a corner went [m]
double flatten_polygons(Polyhedron& part);

}  // namespace riprap::geometry
