// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

/// k and epsilon of still water, where they are asked for: 1e-8 m^2/s^2 and 1e-4 m^2/s^3, nu_t = 9e-14 m^2/s.
void start_turbulence(const GridSettings& settings, GridState& state);

/// Eddy viscosity nu_t = C_mu k^2/epsilon; in the stable variant epsilon is at least what the strain S and rotation W
/// ask for, lambda_2 C_2/C_1 S/W epsilon with S = 2 |sym grad u|^2, W = 2 |skew grad u|^2 [Larsen2018, eq. 2.27], and
/// what keeps normal stresses positive, sqrt(3 S) C_mu k/0.6 [Durbin1996].
void find_eddy_viscosity(const GridSettings& settings, const GridState& state, GridScratch& scratch);

/// Advances k and epsilon by dt and finds the eddy viscosity.
void advance_turbulence(const GridSettings& settings, GridState& state, GridScratch& scratch, double dt);

}  // namespace riprap::fluid::grid
