// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/k_epsilon.hpp"

namespace riprap::fluid::grid {
void start_turbulence(const GridSettings&, GridState&) {}
void find_eddy_viscosity(const GridSettings&, const GridState&, GridScratch&) {}
void advance_turbulence(const GridSettings&, GridState&, GridScratch&, double) {}
}  // namespace riprap::fluid::grid
