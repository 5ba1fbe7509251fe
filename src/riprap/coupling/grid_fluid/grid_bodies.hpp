// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/coupling/grid_fluid/grid_fluid.hpp"

namespace riprap::coupling {

/// Parts of every body in its own frame; a half-space as what it fills of the domain, see place_bodies.
std::vector<std::vector<geometry::Polyhedron>> body_shapes(const FluidScene& scene, const GridFluidSettings& settings);

/// Bodies as they were cut last.
body::Motion cut_motion(const GridFluidFields& fields);

/// Puts parts of bodies where the motion has them, and lets them move as it does at `ahead` after it.
/// @param all  bodies that stand still too
void place_bodies(const FluidScene& scene, const GridFluidSettings& settings,
                  const std::vector<std::vector<geometry::Polyhedron>>& shapes, const body::Motion& motion,
                  double ahead, bool all, std::vector<GridBody>& bodies);

/// Sets the velocities of bodies at `ahead` after the motion. Water does not follow the rate at which blocks strain: a
/// stiff block swings many times in a step of the fluid, and in shorter steps the inertia of the water would come a
/// step late to strains that weigh less than it. What a block displaces by strain shows in the cells alone.
void set_velocities(const body::Motion& motion, double ahead, std::vector<GridBody>& bodies);

/// Per body: never moves, or is not there for the water.
std::vector<std::uint8_t> still_bodies(const FluidScene& scene, const GridFluidSettings& settings);

/// Shares that bodies leave open as they were cut last.
CutBodies cut_again(const FluidScene& scene, const GridFluidSettings& settings, const GridFluidFields& fields);

/// Water at the start: the part of the regions in the open part of each cell, exact for parts of bodies that do not
/// overlap.
fluid::grid::GridState fill_grid(const GridFluidSettings& settings, const std::vector<GridBody>& bodies,
                                 const fluid::grid::OpenShares& open);

/// Water fraction at the start where no body is in the water.
std::vector<double> water_at_start(const GridFluidSettings& settings);

}  // namespace riprap::coupling
