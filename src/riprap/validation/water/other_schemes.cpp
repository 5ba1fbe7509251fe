// SPDX-License-Identifier: Apache-2.0
// The scheme of Mueller and others, kept for comparison, held to what the default is held to.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

/// Water's force on the bottom of a tank over its weight, and the drop of its level, of a case beside this one.
void judge_tank(const CaseSetting& setting, CaseReport& report, const std::string& name,
                std::vector<std::string> overrides) {
    CaseSetting tank = setting;
    tank.folder = setting.folder.parent_path() / "still_tank";
    overrides.emplace_back("end=2");
    WaterTrial trial(tank, overrides);
    trial.run();
    constexpr double weight = 1000 * 9.81 * 0.5 * 1.0;  // of still_tank/case.toml [N/m]
    const double start = 0.5 * trial.now(), end = trial.now();
    report.judge({name + ": force on the bottom of a still tank", "N/m", {}, weight, "m g"},
                 -trial.mean("bottom.fluid_force.y", start, end), Relative{0.02});
}

void judge_float(const CaseSetting& setting, CaseReport& report, const std::string& name,
                 const std::vector<std::string>& overrides) {
    CaseSetting box = setting;
    box.folder = setting.folder.parent_path() / "floating_box";
    WaterTrial trial(box, overrides);
    trial.run();
    constexpr double weight = 500 * 9.81 * 0.28 * 0.2;  // of floating_box/case.toml [N/m]
    const double start = 0.5 * trial.now(), end = trial.now();
    report.judge({name + ": water's force on a floating box over its weight", "-", {}, 1.0, {}},
                 trial.mean("box.fluid_force.y", start, end) / weight, Relative{0.02});
    const double centre =
        trial.model().particles()->filled_volume + 0.28 * 0.1;  // the level with half of the box in it, 1 m wide
    report.judge({name + ": height of the box", "m", {}, centre, "draft of half its height"},
                 trial.mean("box.position.y", start, end), Relative{0.02});
}

}  // namespace

void other_schemes(const CaseSetting& setting, CaseReport& report) {
    const std::vector<std::string> muller{"fluid.scheme=muller", "fluid.artificial_alpha=0.1"};
    judge_tank(setting, report, "muller", muller);
    judge_float(setting, report, "muller", muller);
}

}  // namespace riprap::validation::water
