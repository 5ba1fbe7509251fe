// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"

namespace riprap::fluid::grid {

/// Turns scratch.moved.flux into scratch.inertia.mass_flux: the mass that went through the faces of the mesh in the
/// step, of water and air [kg].
void find_mass_fluxes(const GridSettings& settings, GridScratch& scratch);

/// Pore velocity of a row of velocity cells after the transport alone, into `moved`:
///
///     m_after u = m_before u_start + sum of fluxes, each the mass through a face times the velocity it takes along.
///
/// Masses of velocity cells are means of those of two cells and their fluxes means of the fluxes of these; the velocity
/// is Koren's third-order one from upstream, moved half a step upstream in time unless `is_midpoint`. What one velocity
/// cell loses through a face the next one gains. Where solids move, the mass that stays is that of the fluxes, so that
/// a uniform flow stays uniform around them; a sliver beside a solid, flushed in the step, takes the mean of what comes
/// in: bounded for any step. So does a velocity cell on an open side, half of which lies outside.
/// @param advected  velocity of component a whose momentum is carried, with ghosts [m/s]
/// @param start  flat index of the first face of the row
/// @param count  faces in the row, most_in_row at most (viscous.hpp)
/// @param place  of the first face along the axes
void carry_row(const GridSettings& settings, const GridScratch& scratch, const std::vector<double>& advected, int a,
               bool is_midpoint, std::int64_t start, int count, const std::array<int, 3>& place, double* moved);

}  // namespace riprap::fluid::grid
