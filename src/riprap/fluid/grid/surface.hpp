// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

/// A cell with less than this of water, or of air, holds none [-].
inline constexpr double least_fraction = 1e-10;
inline bool is_mixed(double fraction) { return fraction > least_fraction && fraction < 1 - least_fraction; }

/// Normal of the surface in a cell, out of the water, in cell widths and with |n_0| + |n_1| + |n_2| = 1: the steepest
/// of differences of columns, or Youngs' gradient where that is less aligned with an axis [Aulisa2007].
std::array<double, 3> surface_normal(const CellBox& box, const std::vector<double>& fraction, std::int64_t cell);

/// Places the planes of all mixed cells and of the ghosts beside them.
void reconstruct_surface(const Mesh& mesh, const std::vector<double>& fraction, CellPlanes& planes);

/// Moves the water with scratch.start.carrier for dt: state.fraction, scratch.moved.water_flux, scratch.moved.flux.
/// Directions one after the other, in turn from step to step, with the dilation term of [Weymouth2010], which leaves
/// fractions between 0 and 1 while the Courant number, summed over axes, is below 1/2. Volume by volume,
///
///     (alpha C)_new = (alpha C)_old - sum of F_w + c (C_new - C_old + sum of F),   C = n theta V,
///
/// where the last bracket, zero for a velocity without divergence, is what the pressure solve leaves; c = 1 in cells
/// more than half full at the start and 0 elsewhere. What the brackets add up to, and what is cut off below 1e-10, goes
/// to the mixed cells in proportion to alpha (1 - alpha) C: the water in the domain is that of the books to round-off.
/// Cells that a step flushes by more than a half (slivers beside solids) hand on what they hold at the end of the step,
/// which sets them no bound.
void move_water(const GridSettings& settings, GridState& state, GridScratch& scratch, double dt);

/// Moves the water by the compressive scheme.
void move_water_compressive(const GridSettings& settings, GridState& state, GridScratch& scratch, double dt);

/// Closes the books of water: clips fractions to 0..1, gives every pocket what it held, and to mixed cells outside of
/// pockets what is missing from GridState::water then.
/// @param in_pockets  water that each pocket held at the start of the step [m^3]
void settle_volume(const GridSettings& settings, GridState& state, GridScratch& scratch,
                   const std::vector<double>& in_pockets = {});

/// Water in the domain [m^3].
double water_volume(const GridSettings& settings, const GridState& state, const GridScratch& scratch);

}  // namespace riprap::fluid::grid
