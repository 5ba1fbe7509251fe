// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/multisphere.hpp"

namespace riprap::solid::sphere_dem {

/// A sphere that stands for a piece of the surface of a part, in the frame of the part.
struct SurfaceSample {
    body::ShapeSphere sphere;
    double law_radius{0};  ///< R of the laws of contact [m]
    double area{0};        ///< of the piece, in the plane its length [m^2], [m]
};

}  // namespace riprap::solid::sphere_dem
