// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/coupling/grid_fluid/grid_fluid.hpp"

namespace riprap::coupling {

/// Axis that points most against gravity.
int up_axis(const Vec3& up);

/// Height of still water at the start, along `up`: the highest surface of the regions [m].
double still_level(const GridFluidSettings& settings);

/// Mass of a volume of water: "3.5 kg/m" in a plane scene, "3.5 kg" in space.
std::string mass_of(const GridFluidSettings& settings, double volume);

/// Ends a run in which bodies press a closed pocket of water together by more than joints can let out, or draw one
/// apart.
Outcome pocket_outcome(const FluidScene& scene, const GridFluidSettings& settings, const GridFluid::Scratch& scratch,
                       const fluid::grid::GridState& water, const TimeSpan& span);

/// Ends a run in which the centre of a body that forces move, and that water wets, leaves the domain through a side
/// that is a wall of the water: no wall holds the body there.
/// @param middle  motion of the bodies as they are cut out now; `fields` has those of the step before
Outcome leaving_outcome(const FluidScene& scene, const GridFluidSettings& settings, const GridFluid::Scratch& scratch,
                        const GridFluidFields& fields, const body::Motion& middle, double time);

/// Ends a run in which water vanishes, or comes from nothing: there is no room left for it, or nothing but water.
Outcome mass_outcome(const FluidScene& scene, const GridFluidSettings& settings, const GridFluid::Scratch& scratch,
                     const fluid::grid::GridState& water, double time);

/// Returns the key of an entry of a list, "wave[1]" of the second [[fluid.wave]], so that a problem names the line of
/// its own table. The view lasts as long as the program: a KeyProblem keeps no text of its own for its key.
std::string_view entry_key(std::string_view list, std::size_t entry);

/// Walls that slide, or of another kind than the others, and sides without a wall. Returns rules that contradict each
/// other, and a flow that the water cannot follow.
std::vector<KeyProblem> add_sides(GridFluidSettings& settings);

/// Sides that waves come in through and go out. Returns waves that no theory has or that the cells do not resolve.
std::vector<KeyProblem> add_waves(GridFluidSettings& settings);

/// Sides that water enters and leaves through. Returns those that lie elsewhere, or that waves have already.
std::vector<KeyProblem> add_openings(GridFluidSettings& settings);

/// Stones and boxes in which water is slowed down. Returns stones that lie outside of the domain.
std::vector<KeyProblem> add_zones(GridFluidSettings& settings);

}  // namespace riprap::coupling
