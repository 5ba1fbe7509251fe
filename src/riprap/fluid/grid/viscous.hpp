// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"

namespace riprap::fluid::grid {

/// Forces per volume of the stress mu (grad U + grad U^T) on a row of velocity cells [N/m^3], from
/// scratch.start.carrier's ghosts and values, scratch.stress.viscosity. Viscosities at
/// edges are harmonic means: shear along the surface is the same on both sides of it, and a velocity cell of air is not
/// dragged by all of the water's viscosity. The shear of solids is left to wall_drag.
/// @param start  flat index of the first face of the row
/// @param count  faces in the row, most_in_row at most
/// @param place  of the first face along the axes
void viscous_row(const GridSettings& settings, const GridScratch& s, int a, std::int64_t start, int count,
                 const std::array<int, 3>& place, double* force);

/// Longest piece of a row that is worked on at once: its arrays stay in the first cache [-].
inline constexpr int most_in_row = 256;

/// Shear of solids on the velocity cell of a face per velocity relative to them: a face whose neighbour lies in a solid
/// sees the wall at the distance where the signed distance between the two vanishes [kg/(m^3 s)].
double wall_drag(const GridSettings& settings, const GridScratch& s, int a, std::int64_t face,
                 const std::array<int, 3>& place);

}  // namespace riprap::fluid::grid
