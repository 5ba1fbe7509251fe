// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

/// Place along each axis of the cell with a flat index.
std::array<int, 3> place_of(const CellBox& box, std::int64_t cell);

/// Finds the pockets of a grid that bodies are cut out of: groups of open cells that no open face joins to a side with
/// a given pressure or to the largest group. Units of a plane scene close pockets that would be open in space.
std::vector<Pocket> find_pockets(const GridSettings& settings, const GridScratch& scratch);

/// Takes the mean off the right side in every pocket: a fluid that keeps its volume cannot follow solids that change
/// the volume of a pocket, so what they displace leaves it, or comes in, evenly through its cells.
void balance_pockets(const std::vector<Pocket>& pockets, GridScratch& scratch);

/// Sets the level of the pressure in every pocket, which its own equations leave open: the mean of the open cells
/// around it, as if water could pass in the third direction or through joints thinner than a cell can tell. Where there
/// are none the mean pressure p is nothing.
void level_pockets(const GridSettings& settings, GridState& state, const GridScratch& scratch,
                   const std::vector<Pocket>& pockets, double time);

/// A pocket that solids press together keeps its water, denser than it is, up to this share above what it has room for;
/// what is more goes out as through a joint [-].
inline constexpr double most_overfull = 0.1;

/// A pocket whose water could not follow the bodies that close it has a cavity of up to this share of its water. Bodies
/// miss their predicted places by a hundredth of g dt^2, which is at most 0.45 of a cell, and a pocket is three cells
/// deep or more [-].
inline constexpr double most_hollow = 0.01 * 0.45 / 3;

/// Returns the volume of a pocket that solids leave to water and air [m^3].
double room_of(const Pocket& pocket, const GridScratch& scratch);

/// Returns what every pocket holds before the water moves, with what solids have driven out of cells beside it since
/// the last step [m^3].
std::vector<double> water_of_pockets(const GridSettings& settings, const GridState& state, const GridScratch& scratch);

/// Gives every pocket back the water that it held: to its surface, then to the air that is left in it, then by
/// fractions above 1, up to most_overfull. A pocket that grows and has no air gets a cavity, up to most_hollow; what is
/// more comes from outside.
void settle_pockets(const GridSettings& settings, GridState& state, const GridScratch& scratch,
                    const std::vector<double>& held);

/// Mean water fraction of a pocket: above 1 where solids have pressed it together [-].
double mean_fraction(const GridState& state, const GridScratch& scratch, const Pocket& pocket);

}  // namespace riprap::fluid::grid
