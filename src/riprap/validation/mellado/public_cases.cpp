// SPDX-License-Identifier: Apache-2.0
// Cases of other authors that share contact and coupling with the thesis: cubes in a dam break [Canelas2016], a cube
// that sinks. The scenes are those of the suite `water`, with spheres for cubes and MPS for SPH.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/mellado/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::mellado {

namespace {

using water::interpolated;
using water::WaterTrial;

CaseSetting scene_of(const CaseSetting& setting, const std::string& name) {
    CaseSetting other = setting;
    other.folder = setting.folder.parent_path().parent_path() / "water" / name;
    return other;
}

std::vector<std::string> methods(double spacing, double end) {
    return {"fluid.method=\"wcmps\"", "fluid.smoothing_ratio=1.05", "solid.method=\"sphere_dem\"",
            fmt::format("fluid.spacing={}", spacing), fmt::format("end={}", end)};
}

}  // namespace

void one_cube(const CaseSetting& setting, CaseReport& report) {
    const std::vector<double> at{0.70, 0.88, 1.00, 1.15, 1.28, 1.42, 1.55};
    const std::vector<double> measured{1.86, 2.00, 2.13, 2.41, 2.67, 2.93, 3.16};
    WaterTrial trial(scene_of(setting, "dam_break_cube"), methods(setting.is_full ? 0.0166666667 : 0.05, 1.6));
    trial.run();
    const std::vector<double>& x = trial.column("cube.position.x");
    for (std::size_t i = 0; i < at.size(); ++i) {
        report.judge({fmt::format("place of the cube at {} s", at[i]), "m", measured[i], {}, "one side of the cube"},
                     interpolated(trial.time(), x, at[i]), measured[i] - 0.15, measured[i] + 0.15);
    }
    water::judge_ledger(report, trial);
    write_plot(
        setting, "one_cube",
        {"A dam break carries a cube of spheres",
         "Canelas and others 2016",
         {"time [s]", false},
         {"x from the gate [m]", false},
         {{"measured", at, measured, CurveStyle::markers, -1}, {"ours", trial.time(), x, CurveStyle::line, -1}}});
}

void six_cubes(const CaseSetting& setting, CaseReport& report) {
    WaterTrial trial(scene_of(setting, "dam_break_cubes"), methods(setting.is_full ? 0.0166666667 : 0.05, 1.8));
    trial.run();
    const std::vector<double>&x = trial.column("top.position.x"), &z = trial.column("top.position.z");
    const std::vector<double> passes = water::crossings(trial.time(), z, 0.2);
    report.judge({"the top cube falls below 0.2 m", "s", 1.109, {}, "Canelas and others 2016"},
                 passes.empty() ? std::nan("") : passes.front(), 1.009, 1.209);
    const double speed = (2.5147 - 2.1893) / (1.7903 - 1.5708);
    report.judge({"its mean speed along the flume from 1.57 to 1.79 s", "m/s", speed, {}, {}},
                 (interpolated(trial.time(), x, 1.7903) - interpolated(trial.time(), x, 1.5708)) / (1.7903 - 1.5708),
                 0.85 * speed, 1.15 * speed);
    water::judge_ledger(report, trial);
}

// Three cubes in a row across the flume: no record of theirs is at hand, so symmetry and the order of events are
// judged.
void three_cubes(const CaseSetting& setting, CaseReport& report) {
    std::vector<std::string> changes = methods(setting.is_full ? 0.0166666667 : 0.05, 1.2);
    for (const auto& [name, y] :
         {std::pair{"upper_left", -0.2}, std::pair{"upper_right", 0.2}, std::pair{"top", 0.0}}) {
        changes.push_back(fmt::format("body.{}.position=[1.775,{},0.075]", name, y));
    }
    // The three others stand behind them, out of the way and out of the record.
    for (const auto& [name, y] : {std::pair{"left", -0.2}, std::pair{"middle", 0.0}, std::pair{"right", 0.2}}) {
        changes.push_back(fmt::format("body.{}.position=[3.3,{},0.075]", name, y));
    }
    changes.emplace_back("output.probe.0.body=\"upper_left\"");
    WaterTrial trial(scene_of(setting, "dam_break_cubes"), changes);
    trial.run();
    const std::vector<double>& x = trial.column("upper_left.position.x");
    report.judge({"an outer cube of three at 1.15 s",
                  "m",
                  {},
                  {},
                  "ahead of its start, behind the lone cube's 2.41 m plus one side"},
                 interpolated(trial.time(), x, 1.15), 1.775, 2.41 + 0.15);
    water::judge_ledger(report, trial);
}

void sinking_cube(const CaseSetting& setting, CaseReport& report) {
    const std::vector<double> time{0.0781, 0.1195, 0.1585, 0.1991, 0.2406, 0.2804};
    const std::vector<double> measured{0.12140, 0.11227, 0.10010, 0.08454, 0.06831, 0.05005};
    WaterTrial trial(scene_of(setting, "sinking_block"), methods(setting.is_full ? 0.0025 : 0.00666667, 0.33));
    trial.run();
    const std::vector<double>& z = trial.column("block.position.z");
    double worst = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        worst = std::max(worst, std::abs(interpolated(trial.time(), z, time[i]) - measured[i]));
    }
    report.judge_below({"largest error of its height up to 0.28 s", "m", {}, 0.0, "Qiu and others 2017"}, worst, 5e-3);
    const std::vector<double> passes = water::crossings(trial.time(), z, 0.05);
    report.judge({"passes 0.05 m", "s", 0.281, {}, {}}, passes.empty() ? std::nan("") : passes.front(), 0.95 * 0.281,
                 1.05 * 0.281);
    water::judge_ledger(report, trial);
}

}  // namespace riprap::validation::mellado
