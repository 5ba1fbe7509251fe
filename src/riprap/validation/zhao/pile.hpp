// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "riprap/validation/case_trial.hpp"

namespace riprap::validation::zhao {

/// Equal parts of time over which rest is judged: longer than the slowest swing of a block on its corners [s].
constexpr double rest_window = 0.02;

/// Blocks that fall into a box and come to rest.
struct PileRun {
    double time{0};               ///< at the end [s]
    double kinetic_share{1};      ///< kinetic energy, mean over the last window, over the largest of the run [-]
    double support{0};            ///< upward force of floor and walls, mean over the last window, over the weight [-]
    double energy_error{0};       ///< |residual| of the ledger over the energy turned over [-]
    double max_potential{0};      ///< at the end [-]
    double largest_force{0};      ///< normal force of a contact at the end [N]
    double share_of_bound{0};     ///< largest step over the bound for the contacts of the moment [-]
    double mean_height{0};        ///< of the centres of mass above the floor, by mass [m]
    double fall{0};               ///< by which the centre of mass of all came down [m]
    int escaped{0};               ///< blocks whose centre has left the box
    std::vector<double> times;    ///< ends of the windows [s]
    std::vector<double> kinetic;  ///< means over them, over the largest [-]
    std::vector<std::string> snapshots;  ///< names of the plots that were written
};

/// Steps until the kinetic energy is below 1e-6 of its largest, at most to the end of the case, and draws the scene
/// from the side at the paper's moments 0, 0.5, 1, 2, 3 and 4 s, as far as it gets, and at the end. Where results are
/// written it is saved once a minute and at those moments, in <results>/<name>-<hash>.trial: a killed one goes on.
/// @param width  of the square box, whose corner on the floor is the origin [m]
PileRun fall_to_rest(Trial& trial, double width, const CaseSetting& setting, const std::string& name);

/// Judges a pile at rest, whatever it is made of.
/// @param demanded  the potential that a normal force [N] demands of the softest lasting support [-]
/// @param why       that support in words
void judge_pile(const PileRun& run, const std::function<double(double)>& demanded, const std::string& why,
                const std::string& prefix, CaseReport& report);

}  // namespace riprap::validation::zhao
