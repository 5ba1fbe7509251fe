// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/scene/shapes/shape_kind.hpp"

namespace riprap::scene {

// Convex blocks by their sizes.
ShapeKind box_shape();
ShapeKind cube_shape();
ShapeKind prism_shape();
ShapeKind tetrahedron_shape();
ShapeKind wedge_shape();
ShapeKind octahedron_shape();
ShapeKind dodecahedron_shape();
ShapeKind icosahedron_shape();
ShapeKind sphere_shape();
ShapeKind ellipsoid_shape();
ShapeKind ellipse_shape();
ShapeKind cylinder_shape();
ShapeKind random_hull_shape();
ShapeKind polygon_shape();

}  // namespace riprap::scene
