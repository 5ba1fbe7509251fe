// SPDX-License-Identifier: Apache-2.0
#pragma once

// Trials of a search for the factor of safety, as plain runs of the case.

#include <string>
#include <vector>

#include "riprap/run/study/sweep.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::run {

/// Times of a trial: strength falls from `begins` for `over`, and is held for `hold` [s].
struct TrialTimes {
    double begins{0}, over{0}, hold{0};
    double ramp_end() const { return begins + over; }
    double end() const { return begins + over + hold; }
};

/// Numbers of the bodies that are watched: free ones whose names begin so; all free ones for an empty beginning.
std::vector<std::int32_t> watched_bodies(const sim::Model& model, const std::string& beginning);

/// Returns the size of the largest watched body, twice the distance of its farthest corner from its centre [m].
double largest_size(const sim::Model& model, const std::vector<std::int32_t>& bodies);

/// Usual times of a trial, by T = sqrt(size/g), the time in which a body of that size topples or slides by about half
/// of it: over = hold = 6 T. Strength begins to fall at time 0 where bodies settled before it and there is no water,
/// else at the end of the case, which so is the time that bodies and water have to come to rest at full strength.
TrialTimes usual_times(const sim::Model& model, double size);

/// Lists what all trials set of the case: times, frames to judge by, no expected answers. @param reduces  empty: all
std::vector<std::string> settings_of_trials(const TrialTimes& times, const std::vector<std::string>& reduces);

/// One trial, in a folder "F_1.25000". @param initial  by which strengths are divided at the start
SweepPoint trial_at(double factor, double initial);

}  // namespace riprap::run
