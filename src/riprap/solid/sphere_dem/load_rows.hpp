// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"

namespace riprap::solid::sphere_dem {

/// Gives the ends of every slot their rows, and lists the rows that are merged.
void place_rows(const SphereSet& spheres, Slots& slots, LoadRows& rows);

/// Sums the rows per body, in the order of its spheres.
void gather_loads(const SphereModel& model, const body::BodyState& state, SphereScratch& scratch);

}  // namespace riprap::solid::sphere_dem
