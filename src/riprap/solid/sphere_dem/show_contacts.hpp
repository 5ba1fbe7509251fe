// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/shown_contact.hpp"
#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid::sphere_dem {

/// Adds the contacts of the last evaluation, of spheres with spheres (where it kept their forces) and with walls.
void show_contacts(const SphereModel& model, const SphereState& state, const SphereScratch& scratch,
                   std::vector<contact::ShownContact>& shown);

}  // namespace riprap::solid::sphere_dem
