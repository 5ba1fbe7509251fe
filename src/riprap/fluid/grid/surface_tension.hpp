// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

/// Curvature of the surface in mixed cells, positive around water, 0 elsewhere (scratch.stress.curvature) [1/m], from
/// heights of columns of seven cells across the surface [Cummins2005]; where columns do not reach from water into air,
/// the divergence of normals of the fraction averaged over neighbours [Brackbill1992]. Does nothing without tension.
void find_curvature(const GridSettings& settings, const GridState& state, GridScratch& scratch);

}  // namespace riprap::fluid::grid
