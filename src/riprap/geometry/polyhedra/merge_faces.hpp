// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// Two neighbouring faces are one if every vertex of the smaller is this close to the plane of the larger, as a
/// fraction of length_scale; a corner between two edges is none if it is this close to the line through its neighbours.
inline constexpr double coplanar_tolerance = 1e-9;

/// Joins neighbouring faces that lie in one plane, drops corners that then lie inside an edge and vertices that no face
/// uses. The surface stays the same. Contact counts area by faces, and two halves of one face with equal distance
/// fields would tie everywhere, so shapes are stored merged. Internal and field-carrying faces are not joined.
/// For closed oriented surfaces with plane faces; a group of faces whose outline is not a single loop (a plane with a
/// hole in a concave body) stays as it is.
Polyhedron merge_coplanar_faces(const Polyhedron& polyhedron);

}  // namespace riprap::geometry
