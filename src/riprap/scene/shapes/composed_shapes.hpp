// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/key.hpp"
#include "riprap/scene/shapes/shape_kind.hpp"

namespace riprap::scene {

/// Everything behind a plane.
struct HalfSpaceShape {
    Vec3 normal{};     ///< unit vector out of the solid [-]
    double offset{0};  ///< [m]
    static KeyList<HalfSpaceShape> keys();
};

// Shapes that are no sizes alone: half-spaces, points, files, grounds and unions.
ShapeKind half_space_shape();
ShapeKind hull_shape();
ShapeKind armour_shape();
ShapeKind stl_shape();
ShapeKind obj_shape();
ShapeKind terrain_shape();
ShapeKind mesh_shape();
ShapeKind union_shape();

}  // namespace riprap::scene
