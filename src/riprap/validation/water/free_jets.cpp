// SPDX-License-Identifier: Apache-2.0
// Water through a sharp slot [MilneThomson1968].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

void torricelli(const CaseSetting& setting, CaseReport& report) {
    constexpr double slot = 0.1, width = 1.5, gravity = 9.81;  // half of the slot, of the tank; case.toml [m], [m/s^2]
    constexpr double contraction = std::numbers::pi / (std::numbers::pi + 2);
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.00625"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    // The jet leaves with the head over its middle, contraction slot/2 above the floor.
    const std::vector<double>& volume = trial.column("left_behind");
    const double start = 0.6, end = trial.now();
    std::vector<double> ideal;  // sqrt(2 g head) of the level of the moment
    for (const double v : volume) {
        ideal.push_back(slot * std::sqrt(2 * gravity * (v / width - 0.5 * contraction * slot)));
    }
    const double lost = interpolated(trial.time(), volume, start) - volume.back();
    report.judge({fmt::format("flow over slot times sqrt(2 g H), {} to {:.1f} s", start, end),
                  "-",
                  {},
                  contraction,
                  "pi/(pi + 2)"},
                 lost / integral(trial.time(), ideal, start, end), Relative{0.04});
    judge_ledger(report, trial);
}

}  // namespace riprap::validation::water
