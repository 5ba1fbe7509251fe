// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/coupling/grid_fluid/grid_fluid.hpp"

namespace riprap::coupling {

/// Share of all water that may be missing: round-off of sums over cells [-].
inline constexpr double share_of_water_missing = 1e-9;
/// Bodies close pockets thinner than so many cells as they come to rest on others: the step in which the way out
/// becomes narrower than a joint may take them 0.05 + 0.45/2 of a cell farther, and that goes through joints.
inline constexpr double least_cells = 3;

/// Finds the pockets of a step that carry bodies. Those below 0.1 % of all water and those thinner than `least_cells`
/// have joints that let water out.
std::vector<PressedPocket> pressed_pockets(const FluidScene& scene, const GridFluidSettings& settings,
                                           const GridFluid::Scratch& scratch, fluid::grid::GridState& water,
                                           double time);

/// Raises the pressure of these pockets to what carries their bodies. The equations of a pocket leave the level of its
/// pressure open, and an incompressible fluid has none that a load could find. Water has one: with its excess e and the
/// volume Q dt that bodies take of a pocket of room V, at the velocities of the end of the step,
///
///     p_k = K (e_k + Q_k dt/V_k),   Q_k = Q_k0 + dt sum_l M_kl p_l,   K = rho c^2, c = 1480 m/s,
///
/// where Q_k0 is that under the loads without these pressures and M what pressures do to the bodies between: a small
/// system, solved for all pockets together, so that the loads answer in full what they do in the step. That is the
/// backward Euler rule for places at mid-steps, x_(n+3/2) = x_(n+1/2) + dt v_(n+1): stable for any dt. Water does not
/// tear: it holds bodies that are drawn out of a pocket too.
/// @param loads  on bodies, without the pressures
void press_pockets(const FluidScene& scene, const GridFluidSettings& settings, const CouplingState& coupling,
                   const GridFluid::Scratch& scratch, const body::Motion& middle, const TimeSpan& span,
                   const std::vector<GridLoad>& loads, fluid::grid::GridState& water);

}  // namespace riprap::coupling
