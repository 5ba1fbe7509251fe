// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where bodies will be, as the fluid is told: for the sources of this folder only.

#include <cstddef>
#include <vector>

#include "riprap/core/step.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/scratch_data.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::sim {

/// Predicts the motion of all bodies at the beginning and in the middle of a span that begins `since` seconds after the
/// State, from its velocities, what they gained over earlier spans and the guessed accelerations.
void predict(const Model& model, const State& state, const TimeSpan& span, double since, Prediction& prediction);
/// Fills the motion in the middle of the span anew, from the present guess.
void predict_middle(const Model& model, const TimeSpan& span, Prediction& prediction);

/// Adds the velocity that free bodies gain over a span under the loads of the fluid. The work that spans of the fluid
/// count, each with its own loads and velocities, is then that of their mean loads over the step of the solids.
void note_gain(const Model& model, const State& state, const body::Loads& loads, double dt, Prediction& prediction);

/// Begins the ways of a step of length dt: the fluid has seen none yet, and has the last step to catch up with.
void begin_ways(const Model& model, const State& state, double dt, Prediction& prediction);
/// Adds the way of a span of length dt as the fluid saw it, and notes what its density was not told of it.
void note_way(double dt, Prediction& prediction, coupling::CouplingState& coupling);
/// Notes what the fluid did not see of the step that took free bodies from `before` to the State: an impact within the
/// step, a contact that became stiffer. Walls of particles make up for it over the next step, so that the work of the
/// water and that on the bodies differ by
///
///     F_N d_N - sum_n (F_n - F_(n-1)) d_(n-1),
///
/// F_n the load of step n and d_n the way that it missed: nothing adds up under an even load.
void note_missed_way(const body::BodyState& before, const Prediction& prediction, State& state);

/// Returns the accelerations over the last step: the first guess of this one.
std::vector<body::Acceleration> last_accelerations(const coupling::CouplingState& coupling);

/// Returns the acceleration of a body under the loads of the fluid plus what else accelerated it in the last step, none
/// along axes that it is locked along.
body::Acceleration response(const body::BodySet& bodies, const coupling::CouplingState& coupling,
                            const body::BodyKinematics& kinematics, const body::Loads& loads, std::size_t b);

/// Returns a moment of inertia of every body, the mean of the principal ones [kg m^2].
std::vector<double> mean_inertia(const body::BodySet& bodies);

/// Returns the rotation of a body between two states [rad].
Vec3 turn_between(const body::BodyState& before, const body::BodyState& after, std::size_t b);

}  // namespace riprap::sim
