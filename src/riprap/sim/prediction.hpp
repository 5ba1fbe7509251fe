// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where bodies will be, as the fluid is told: for the sources of this folder only.

#include <cstddef>
#include <vector>

#include "riprap/core/step.hpp"
#include "riprap/sim/step_context.hpp"

namespace riprap::sim {

/// Begins the prediction of a step: the first guess is the accelerations over the last one, the fluid has seen no way
/// yet, and has the last step to catch up with.
void begin_prediction(StepContext& step);

/// Predicts the motion of all bodies at the beginning and in the middle of a span of the step, from the velocities of
/// the State, what they gained over earlier spans and the guessed accelerations. Paddles that absorb waves are
/// corrected first.
void predict(StepContext& step, const TimeSpan& span);
/// Fills the motion in the middle of the span anew, from the present guess.
void predict_middle(StepContext& step, const TimeSpan& span);

/// Adds the velocity that free bodies gain over a span of length dt under the loads of the fluid. The work that spans
/// of the fluid count, each with its own loads and velocities, is then that of their mean loads over the step of the
/// solids.
void note_gain(StepContext& step, double dt);

/// Adds the way of a span of length dt as the fluid saw it, and notes what its density was not told of it.
void note_way(StepContext& step, double dt);
/// Notes what the fluid did not see of the step that took free bodies to the State: an impact within the step, a
/// contact that became stiffer. Walls of particles make up for it over the next step, so that the work of the water and
/// that on the bodies differ by
///
///     F_N d_N - sum_n (F_n - F_(n-1)) d_(n-1),
///
/// F_n the load of step n and d_n the way that it missed: nothing adds up under an even load.
void note_missed_way(StepContext& step);

/// Returns the acceleration of a body under the loads of the fluid over the span plus what else accelerated it in the
/// last step, none along axes that it is locked along.
body::Acceleration response(const StepContext& step, std::size_t b);

/// Returns a moment of inertia of every body, the mean of the principal ones [kg m^2].
std::vector<double> mean_inertia(const body::BodySet& bodies);

/// Returns the rotation of a body between two states [rad].
Vec3 turn_between(const body::BodyState& before, const body::BodyState& after, std::size_t b);

}  // namespace riprap::sim
