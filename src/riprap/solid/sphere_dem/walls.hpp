// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid::sphere_dem {

/// Finds the spheres that touch parts and triangles, into `scratch.walls` in the order of (sphere, wall). Of triangles
/// that share the edge or corner nearest to a sphere one counts, and none where one of them is nearer by its face.
void find_walls(const SphereModel& model, SphereScratch& scratch);

/// Loads of those contacts, added to `scratch.loads` of both bodies; springs carried over and advanced.
/// @param dt  since the last evaluation [s]
/// @returns energies of this step; that of lost springs is in the friction loss
ContactSums respond_to_walls(const SphereModel& model, const body::BodyState& bodies, double dt, SphereState& state,
                             SphereScratch& scratch);

}  // namespace riprap::solid::sphere_dem
