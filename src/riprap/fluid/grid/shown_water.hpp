// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"
#include "riprap/fluid/shown_water.hpp"

namespace riprap::fluid::grid {

/// Points in the middle of the water of cells that are at least half full: in cells with a surface they lie half a cell
/// below its plane, so that balls as wide as a cell end at it. Polygons of the planes, cut by their cells.
ShownWater show_water(const GridSettings& settings, const GridState& state, const OpenShares& open);

}  // namespace riprap::fluid::grid
