// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid::sphere_dem {

/// Loads of all contacts of spheres with spheres into their slots, springs advanced, eight contacts at a time.
/// @param dt  since the last evaluation [s]
ContactSums respond(const SphereModel& model, const body::BodyState& bodies, double dt, SphereState& state,
                    SphereScratch& scratch);

/// Sums the loads of the slots per body, in the order of the spheres and of their slots.
void gather_loads(const SphereModel& model, const body::BodyState& state, SphereScratch& scratch);

}  // namespace riprap::solid::sphere_dem
