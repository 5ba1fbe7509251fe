// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/geometry/ground/triangle_field.hpp"
#include "riprap/geometry/surface/surface_features.hpp"
#include "riprap/solid/affine/blocks.hpp"

namespace riprap::solid::affine {

/// A surface of triangles that blocks meet, in the frame of its body: Model.
struct Ground {
    geometry::TriangleField field;       ///< its triangles, and which are near a place
    geometry::SurfaceFeatures features;  ///< edges, points and cells

    explicit Ground(geometry::TriangleField surface) : field(std::move(surface)), features(field.mesh()) {}
};

/// Makes a shape of ground. A block of it is never moved by loads.
Shape ground_shape(geometry::TriangleField surface);

}  // namespace riprap::solid::affine
