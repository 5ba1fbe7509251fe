// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid::sphere_dem {

/// Adds the loads of all contacts of spheres with spheres to their rows and advances their springs, eight at a time.
/// @param dt  since the last evaluation [s]
ContactSums respond(const SphereModel& model, const body::BodyState& bodies, double dt, SphereState& state,
                    SphereScratch& scratch);

}  // namespace riprap::solid::sphere_dem
