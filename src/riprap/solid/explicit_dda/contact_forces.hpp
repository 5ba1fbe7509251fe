// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/explicit_dda/advance.hpp"

// Contacts of one step of explicit DDA, in the order in which advance() calls them.

namespace riprap::solid::explicit_dda {

/// Answers every contact point that was found with the force of its springs.
/// @param time  since the last evaluation [s]
void evaluate_contacts(const affine::BlockSystem& system, const Settings& settings, const affine::BlockState& state,
                       double time, Scratch& scratch);

/// Adds up loads and bounds of all contact points and remembers those that are closed: once along the list, which is
/// longer than any cache.
void sum_and_remember(const affine::BlockSystem& system, const affine::BlockState& state, double dt, Scratch& scratch,
                      affine::BlockContactHistory& history, StepReport& report);

/// Returns the work that the dashpots took: along the way of the step, half of it with the velocities before the kick
/// and half with those after it.
double dashpot_work(const affine::BlockSystem& system, const Scratch& scratch, const affine::BlockState& state,
                    double dt);

/// Books what springs of lost contacts held, less what those of new ones of the same pair begin with: dissipated.
void book_lost_contacts(const Scratch& scratch, const affine::BlockContactHistory& history, double dt,
                        StepReport& report);

}  // namespace riprap::solid::explicit_dda
