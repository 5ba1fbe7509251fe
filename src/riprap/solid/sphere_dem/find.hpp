// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid::sphere_dem {

/// Brings the candidate pairs up to date: slots of spheres, and `scratch.wall_pairs` of spheres and walls.
void find_candidates(const SphereModel& model, SphereScratch& scratch);

/// Brings the candidate pairs up to date and finds which spheres touch; rows of `state.contacts` become those of the
/// pairs that touch now, springs carried over by key. `scratch.wall_pairs` has the candidates of spheres and walls.
/// @returns energy of the springs whose contact was lost [J]
double find_contacts(const SphereModel& model, SphereState& state, SphereScratch& scratch);

}  // namespace riprap::solid::sphere_dem
