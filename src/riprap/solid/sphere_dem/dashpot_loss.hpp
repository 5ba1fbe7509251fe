// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid::sphere_dem {

/// Energy that dashpots take from the bodies in a kick [J].
struct DashpotLoss {
    double before{0};  ///< until the kick: -dt/2 sum F_d . u_-
    double all{0};     ///< with what they take after it: -dt sum F_d . (u_- + u_+)/2
};

/// Returns what the dashpots of the last evaluation take, with F_d the force of a dashpot on A, u the velocity of A
/// against B at the contact, before and after the kick by all forces: the kinetic energy that the part F_d of the
/// forces takes, to round-off. A velocity halfway that is foreseen from the dashpot alone leaves out what springs,
/// weight and other contacts change within the kick.
/// @param bodies  after the kick, at the poses of the evaluation
/// @param power   -sum F_d . u_-, as the evaluation found it [W]
/// @param dt      length of the kick [s]
DashpotLoss dashpot_loss(const SphereModel& model, const body::BodyState& bodies, const SphereState& state,
                         double power, double dt, SphereScratch& scratch);

}  // namespace riprap::solid::sphere_dem
