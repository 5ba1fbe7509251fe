// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// Water as it is drawn, whatever computes it: a point for every particle or wet cell and, of a fluid in cells, its
/// surface as flat pieces.
struct ShownFluid {
    double spacing{0};             ///< between points [m]
    std::vector<Vec3> place;       ///< [m]
    std::vector<Vec3> velocity;    ///< [m/s]
    bool has_density{false};       ///< it differs from place to place
    std::vector<float> density;    ///< half a step behind the places [kg/m^3]
    std::vector<float> pressure;   ///< at that density [Pa]
    std::vector<std::int32_t> id;  ///< of the particle for life, or number of the cell

    std::vector<Vec3> corner;               ///< of the polygons of the surface; none where points show it [m]
    std::vector<std::int32_t> polygon_end;  ///< where the corners of each end; planar: two corners for each depth
};

}  // namespace riprap::fluid
