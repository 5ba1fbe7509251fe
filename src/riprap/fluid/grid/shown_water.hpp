// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

/// Water as it is drawn: a point for every wet cell, and its surface as flat pieces.
struct ShownWater {
    double spacing{0};             ///< between points [m]
    std::vector<Vec3> place;       ///< [m]
    std::vector<Vec3> velocity;    ///< [m/s]
    std::vector<float> pressure;   ///< [Pa]
    std::vector<std::int32_t> id;  ///< number of the cell

    std::vector<Vec3> corner;               ///< of the polygons of the surface [m]
    std::vector<std::int32_t> polygon_end;  ///< where the corners of each end; planar: two corners for each depth
};

/// Points in the middle of the water of cells that are at least half full: in cells with a surface they lie half a cell
/// below its plane, so that balls as wide as a cell end at it. Polygons of the planes, cut by their cells.
ShownWater show_water(const GridSettings& settings, const GridState& state, const OpenShares& open);

}  // namespace riprap::fluid::grid
