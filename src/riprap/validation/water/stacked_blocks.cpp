// SPDX-License-Identifier: Apache-2.0
// Blocks on each other under water: joints carry buoyant weights.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

void stacked_blocks(const CaseSetting& setting, CaseReport& report) {
    constexpr int count = 5;
    constexpr double side = 0.16, buoyant = (2500 - 1000) * 9.81 * side * side;  // of case.toml; weight of one [N/m]
    std::vector<std::string> longer;
    if (setting.is_full) {
        longer = {"end=60"};
    }
    WaterTrial trial(setting, longer);
    trial.run();
    const double end = trial.now(), start = 0.5 * end;
    double carried = 0, drift = 0;
    for (int i = count - 1; i >= 0; --i) {
        const std::string block = fmt::format("block[{}]", i);
        carried += trial.mean(block + ".contact_force.y", start, end);
        report.judge({fmt::format("force in the joint under block {}, mean of the second half", i + 1),
                      "N/m",
                      {},
                      buoyant * (count - i),
                      "(rho_s - rho) g V of the blocks above it"},
                     carried, Relative{0.01});
        for (const char* axis : {"x", "y"}) {
            const std::vector<double>& place = trial.column(fmt::format("{}.position.{}", block, axis));
            drift = std::max(drift, std::abs(place.back() - interpolated(trial.time(), place, start)));
        }
    }
    report.judge_below({"largest motion of a block in the second half over its side", "-", {}, 0.0, {}}, drift / side,
                       1e-4);
    judge_ledger(report, trial);
}

}  // namespace riprap::validation::water
