// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// Water of a field as it is drawn, whatever computes it: a point for every wet cell, and its surface as flat pieces.
struct ShownWater {
    double spacing{0};             ///< between points [m]
    std::vector<Vec3> place;       ///< [m]
    std::vector<Vec3> velocity;    ///< [m/s]
    std::vector<float> pressure;   ///< [Pa]
    std::vector<std::int32_t> id;  ///< number of the cell

    std::vector<Vec3> corner;               ///< of the polygons of the surface [m]
    std::vector<std::int32_t> polygon_end;  ///< where the corners of each end; planar: two corners for each depth
};

}  // namespace riprap::fluid
