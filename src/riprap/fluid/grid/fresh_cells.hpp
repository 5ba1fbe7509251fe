// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

/// Gives cells that solids opened since the last step the mean water fraction of the cells that their open faces lead
/// to, by the area of these; through further fresh cells where no other is beside them. What they hold says which of
/// water and air fills the room that opens (docs/theory/grid.md, 3): a closed cell keeps what was in it long ago.
void fill_fresh_cells(const GridSettings& settings, GridState& state, const GridScratch& scratch);

/// Finds cells that open to the other side than before: a wall thinner than a cell has moved through their middle, and
/// what they held is not what is on its other side. They are fresh as those that solids opened.
/// @param scratch  of the last step
/// @param shares  now
std::vector<std::int64_t> find_turned_cells(const GridSettings& settings, const GridScratch& scratch,
                                            const OpenShares& shares);

}  // namespace riprap::fluid::grid
