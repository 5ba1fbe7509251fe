// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/core/step.hpp"
#include "riprap/solid/planar_dda/model.hpp"
#include "riprap/solid/planar_dda/state.hpp"
#include "riprap/solid/solid_scene.hpp"

// Between the bodies of a planar scene and the blocks of planar DDA: one body, one block, in the same order.

namespace riprap::solid::planar_dda {

/// Says which blocks loads move over the span, and how far the others go in it.
void drive_blocks(const SolidScene& scene, const TimeSpan& span, const body::BodyState& bodies, const State& state,
                  Model& model, std::vector<Unknowns>& driven);

/// Gathers force, torque and pull of given loads.
void read_loads(const body::LoadView& loads, std::vector<Unknowns>& sums);

/// Writes poses, velocities, angular momenta, stretches U (body axes) and rates of stretching D (world axes).
void write_bodies(const Model& model, const State& state, body::BodyState& bodies);

}  // namespace riprap::solid::planar_dda
