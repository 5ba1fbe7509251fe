// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid::sphere_dem {

/// Shares of the simultaneous contacts of every pair of bodies of which one has several spheres, into `scratch.weight`
/// and the weights of `scratch.walls`.
///
/// N equal contacts are a spring and a dashpot N times as strong as one: restitution falls with the number of spheres,
/// as sqrt(N) times the contact ratio. `divide` counts each by 1/N with N = (sum of overlaps)/(largest overlap), which
/// is the number of equal contacts, and changes continuously as a contact begins or ends. `closest` counts the deepest
/// alone.
void share_contacts(const SphereModel& model, const SphereState& state, SphereScratch& scratch);

}  // namespace riprap::solid::sphere_dem
