// SPDX-License-Identifier: Apache-2.0
#pragma once

// The boundary particles of a step of the water, and the bodies that carry them: for the sources of this folder only.

#include <string>
#include <vector>

#include "riprap/coupling/added_mass.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"
#include "riprap/sim/water_scratch.hpp"

namespace riprap::sim {

/// What stays the same over a run: who never moves, and the share of a body's mass that its wall treatment feeds back:
/// twice the water that its first layer would hold, as pressure is carried over about two spacings into the wall.
void describe_bodies(const Model& model, WaterScratch& scratch);

/// Bodies and their boundary particles as they are at t_n, where they speed up as `guess` says. Notes in the State
/// which samples the water may feel in this step.
void place_walls_at_start(const Model& model, State& state, const std::vector<body::Acceleration>& guess, double dt,
                          WaterScratch& scratch);

/// Those at mid-step, where scratch.middle has the bodies with their velocities of t_n.
void place_walls_at_middle(const Model& model, const State& state, const std::vector<body::Acceleration>& guess,
                           double dt, WaterScratch& scratch);

/// A body that moves and has boundary particles among the layers of an opening, in words; empty where there is none.
/// Bodies that stay are looked at when the case is read.
std::string find_intruder(const Model& model, const WaterScratch& scratch);

}  // namespace riprap::sim
