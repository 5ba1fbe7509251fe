// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/geometry/planar/planar_polygon.hpp"
#include "riprap/solid/solid_scene.hpp"

namespace riprap::solid::planar_dda {

/// Returns the corners of a planar prism about its own origin, counter-clockwise seen from +z [m].
geometry::Polygon corners_of_prism(const geometry::ShapeSet& shapes, ShapeId shape);

/// Returns the outline of the parts of a body in the body frame: pieces that share an edge are joined, concave outlines
/// included. Empty where the parts do not make one simple polygon.
geometry::Polygon outline_of(const SolidScene& scene, BodyId body);

/// Returns a rectangle that stands for the half-space of a body in the body frame: one side of length 2 `extent` lies
/// in the plane, about the point of it that is nearest to `about` [m].
geometry::Polygon outline_of_half_space(const SolidScene& scene, BodyId body, const geometry::Vec2& about,
                                        double extent);

}  // namespace riprap::solid::planar_dda
