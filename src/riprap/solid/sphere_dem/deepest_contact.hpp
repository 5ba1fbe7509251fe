// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"

namespace riprap::solid::sphere_dem {

/// The contact that is deepest beside the smaller radius.
struct DeepestContact {
    BodyId a, b;      ///< invalid where nothing touches
    double share{0};  ///< overlap over the smaller radius [-]
};

/// Finds the deepest contact of the last evaluation, of spheres or with walls; for messages.
DeepestContact deepest_contact(const SphereModel& model, const SphereState& state, const SphereScratch& scratch);

/// Returns the largest overlap of those contacts [m].
double largest_overlap(const SphereModel& model, const SphereState& state, const SphereScratch& scratch);

}  // namespace riprap::solid::sphere_dem
