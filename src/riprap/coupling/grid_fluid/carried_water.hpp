// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/coupling/grid_fluid/settings.hpp"
#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::coupling {

/// Mean velocity of a flow across a face of cells: the difference of its stream function between the corners of the
/// face in the x-y plane, over their distance [m/s]. Cells then neither gain nor lose volume, and as much comes in
/// through sides as goes out.
/// @param a     axis across the face; 0 along z
/// @param face  its place: the cell on its high side
double mean_across(const fluid::grid::Mesh& mesh, const fluid::Flow& flow, double viscosity, int a,
                   const std::array<int, 3>& face, double time);

/// Gives all faces the mean velocity of the flow of the case [m/s]; walls let nothing through.
void set_flow_velocity(const GridFluidSettings& settings, double time, std::array<std::vector<double>, 3>& velocity);

/// Moves the water for dt [s] with the flow of the case at mid-step, and leaves the velocity of the flow at the end.
void carry_with_flow(const GridFluidSettings& settings, fluid::grid::GridState& water,
                     fluid::grid::GridScratch& scratch, double dt);

}  // namespace riprap::coupling
