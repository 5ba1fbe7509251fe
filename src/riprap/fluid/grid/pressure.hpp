// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

/// Solves for P so that no volume is made or lost in any cell,
///
///     sum over faces of A (U - dt m (P_above - P_below)/d) + d(theta V)/dt = 0,
///
/// and corrects the velocity. Conductances are dt m A/d, so resistance, added mass, density and open areas all enter.
/// @param is_rough  the velocity enters the explicit momentum alone, and another pressure follows
linear::PoissonReport project_velocity(const GridSettings& settings, GridState& state, GridScratch& scratch, double dt,
                                       bool is_rough = false);

/// Largest residual of the volume balance over cells, over cell volume [1/s].
double largest_divergence(const GridSettings& settings, const GridState& state, const GridScratch& scratch);

}  // namespace riprap::fluid::grid
