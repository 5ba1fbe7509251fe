// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid::sphere_dem {

/// Shares of the simultaneous contacts of every pair of bodies of which one has several spheres, into `scratch.weight`
/// and the weights of `scratch.walls`.
///
/// N equal contacts are a spring and a dashpot N times as strong as one, so that restitution falls with the number of
/// spheres: the contact ratio of the pair of bodies is sqrt(N) times that of one contact. With N = (sum of
/// overlaps)/(largest overlap), the number of equal contacts, which changes continuously as a contact begins or ends:
/// `dashpots` counts dashpots by 1/sqrt(N) and leaves springs alone, which keeps both the restitution and the elastic
/// energy of every spring; `divide` counts both by 1/N, as soft as one contact; `closest` counts the deepest alone.
void share_contacts(const SphereModel& model, const SphereState& state, SphereScratch& scratch);

}  // namespace riprap::solid::sphere_dem
