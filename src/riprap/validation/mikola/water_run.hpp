// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "riprap/validation/case_trial.hpp"

namespace riprap::validation::mikola {

/// Readings of the gauges of a case, and residuals of the ledgers of its run.
struct WaterRecords {
    std::vector<double> time;                ///< [s]
    std::vector<std::vector<double>> gauge;  ///< per gauge of the case, in its order, per time [its unit]
    double energy_residual{0};               ///< largest so far, without its sign [J]
    double energy_turnover{0};               ///< so far [J]
    double momentum_residual{0};             ///< largest so far, over weight of water times time [-]
};

/// Advances a scene with water to `time` and reads its gauges every `interval` [s]; `look` is called as often.
void run_water(Trial& trial, WaterRecords& records, double time, double interval,
               const std::function<void(const Trial&)>& look = {});

/// Number of particles that are more than `depth` [m] inside a solid of a planar scene.
int count_inside_solids(const Trial& trial, double depth);

/// Judges both ledgers: energy closes to 1 % of what was turned over, momentum to the round-off of float.
void judge_ledgers(CaseReport& report, const std::string& run, const WaterRecords& records);

/// Particles, thinned to about `count`, and the outlines of the free bodies.
Plot water_view(const Trial& trial, const std::string& title, int count = 6000);

}  // namespace riprap::validation::mikola
