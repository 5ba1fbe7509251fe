// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

/// Finds the pockets of a grid that bodies are cut out of: groups of open cells that no open face joins to a side with
/// a given pressure or to the largest group. Units of a plane scene close pockets that would be open in space.
std::vector<Pocket> find_pockets(const GridSettings& settings, const GridScratch& scratch);

/// Takes the mean off the right side in every pocket: a fluid that keeps its volume cannot follow solids that change
/// the volume of a pocket, so what they displace leaves it, or comes in, evenly through its cells.
void balance_pockets(const std::vector<Pocket>& pockets, GridScratch& scratch);

/// Sets the level of the pressure in every pocket, which its own equations leave open: the mean of the open cells
/// around it, as if water could pass in the third direction or through joints thinner than a cell can tell.
void level_pockets(const GridSettings& settings, GridState& state, const GridScratch& scratch,
                   const std::vector<Pocket>& pockets, double time);

}  // namespace riprap::fluid::grid
