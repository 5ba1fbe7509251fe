// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"

namespace riprap::coupling {

/// Power of walls of the domain that slide along themselves [W], in 2D [W/m]: the shear mu du/dn by which the step
/// moves the water beside them, of scratch.start.carrier and its ghosts, times their velocity and area.
double power_of_sliding_sides(const fluid::grid::GridSettings& settings, const fluid::grid::GridScratch& scratch);

}  // namespace riprap::coupling
