// SPDX-License-Identifier: Apache-2.0
#pragma once

// Trials of the solids for water that cannot give way, whose loads follow the way of bodies within the step: for the
// sources of this folder only.

#include <functional>
#include <span>

#include "riprap/sim/step_context.hpp"

namespace riprap::sim {

/// Leads the accelerations that the fluid is told next along the way on which bodies went from the State to `after` in
/// a trial of the step. Tells whether contacts made that another way than it was told, by a thousandth of their
/// acceleration and gravity. @param feedback  of the fluid: the bodies whose accelerations are iterated
bool go_another_way(StepContext& step, const body::BodyState& after, std::span<const double> feedback);

/// Moves the solids over the step on trial, with the loads found, and takes them back. Tells whether they went another
/// way than the fluid was told; then the accelerations that it is told next lead there. Its time counts as that of the
/// solids alone, not as that of the fluid, in whose stage it lies.
bool foresee_contacts(StepContext& step);

/// Repeats trials until bodies go the way that the fluid was told, 16 at most, each but the last followed by new loads.
/// @param goes_another_way  a trial: does the way differ?
/// @param find_loads        with the way that the trial led to
/// @returns whether it came to differ no more
bool settle_ways(const std::function<bool()>& goes_another_way, const std::function<void()>& find_loads);

}  // namespace riprap::sim
