// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"

namespace riprap::fluid::grid {

/// Force per volume of the stress mu (grad U + grad U^T) on the velocity cell at a face [N/m^3], from
/// scratch.carrier's ghosts and values and scratch.viscosity. Viscosities at edges are harmonic means: shear along the
/// surface is the same on both sides of it, and a velocity cell of air is not dragged by all of the water's viscosity.
/// The shear of solids is left to find_wall_drag.
double viscous_force(const GridSettings& settings, const GridScratch& s, int a, std::int64_t face,
                     const std::array<int, 3>& place);

/// Shear of solids on each velocity cell per velocity relative to them (scratch.wall_drag): a face whose neighbour lies
/// in a solid sees the wall at the distance where the signed distance between the two vanishes [kg/(m^3 s)].
void find_wall_drag(const GridSettings& settings, GridScratch& s);

}  // namespace riprap::fluid::grid
