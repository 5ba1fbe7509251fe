// SPDX-License-Identifier: Apache-2.0
// Cases of other authors that share contact and coupling with the thesis: cubes in a dam break [Canelas2016], a cube
// that sinks. The scenes are those of the suite `water`, with spheres for cubes and MPS for SPH; the tower of three
// cubes has its own.
#include <fmt/format.h>

#include <algorithm>
#include <array>
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
    return {"fluid.method=\"wcmps\"",           "fluid.smoothing_ratio=1.05",  "fluid.weight=\"reciprocal\"",
            "fluid.wall_pressure=\"mirrored\"", "solid.method=\"sphere_dem\"", fmt::format("fluid.spacing={}", spacing),
            fmt::format("end={}", end)};
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

namespace {

/// The cube on top in the experiment, read off the published curves: its height on its way down, its x when it is swept
/// off.
struct TopCube {
    std::string_view title;
    std::vector<double> fall_time, fall;    ///< [s], [m]
    std::vector<double> sweep_time, sweep;  ///< [s], [m]
    std::array<double, 2> places_at;        ///< times at which x is judged [s]
};

/// Bands as those of water/dam_break_cubes, set before the first run: 0.1 s, one side of a cube.
void judge_top(const CaseSetting& setting, CaseReport& report, const WaterTrial& trial, std::string_view name,
               const TopCube& top) {
    const std::vector<double>&x = trial.column("top.position.x"), &z = trial.column("top.position.z");
    const double measured = water::crossings(top.fall_time, top.fall, 0.2).front();
    const std::vector<double> passes = water::crossings(trial.time(), z, 0.2);
    report.judge({"the top cube falls below 0.2 m", "s", measured, {}, "Canelas and others 2016; friction 0.45"},
                 passes.empty() ? std::nan("") : passes.front(), measured - 0.1, measured + 0.1);
    for (const double at : top.places_at) {
        const double place = interpolated(top.sweep_time, top.sweep, at);
        report.judge({fmt::format("place of the top cube at {} s", at), "m", place, {}, "one side of the cube"},
                     interpolated(trial.time(), x, at), place - 0.15, place + 0.15);
    }
    water::judge_ledger(report, trial);
    write_plot(setting, name,
               {std::string(top.title),
                "Canelas and others 2016",
                {"time [s]", false},
                {"x from the gate, height [m]", false},
                {{"height, measured", top.fall_time, top.fall, CurveStyle::markers, 0},
                 {"height, ours", trial.time(), z, CurveStyle::line, 0},
                 {"x, measured", top.sweep_time, top.sweep, CurveStyle::markers, 1},
                 {"x, ours", trial.time(), x, CurveStyle::line, 1}}});
}

}  // namespace

void six_cubes(const CaseSetting& setting, CaseReport& report) {
    const TopCube top{"The top cube of six in a dam break",
                      {0.3664, 0.7898, 0.9204, 0.9760, 1.0511, 1.0871, 1.1231, 1.1727, 1.2132, 1.2598},
                      {0.3913, 0.3900, 0.3893, 0.3295, 0.2599, 0.2279, 0.1829, 0.1198, 0.0551, 0.0469},
                      {0.4929, 0.9027, 1.0923, 1.2026, 1.2894, 1.3776, 1.4209, 1.4750, 1.5090, 1.5708, 1.6280, 1.6992,
                       1.7578, 1.7903},
                      {1.7804, 1.8272, 1.7921, 1.7721, 1.8256, 1.9071, 1.9782, 2.0418, 2.1079, 2.1893, 2.2833, 2.3723,
                       2.4765, 2.5147},
                      {1.3776, 1.7903}};
    WaterTrial trial(scene_of(setting, "dam_break_cubes"), methods(setting.is_full ? 0.0166666667 : 0.05, 1.8));
    trial.run();
    const auto mean_speed = [](const std::vector<double>& time, const std::vector<double>& place) {
        constexpr double start = 1.5708, end = 1.7903;
        return (interpolated(time, place, end) - interpolated(time, place, start)) / (end - start);
    };
    const double speed = mean_speed(top.sweep_time, top.sweep);
    report.judge({"its mean speed along the flume from 1.57 to 1.79 s", "m/s", speed, {}, {}},
                 mean_speed(trial.time(), trial.column("top.position.x")), 0.85 * speed, 1.15 * speed);
    judge_top(setting, report, trial, "six_cubes", top);
}

// A tower of three, one on another.
void three_cubes(const CaseSetting& setting, CaseReport& report) {
    const TopCube top{"The top cube of a tower of three in a dam break",
                      {0.3592, 0.6524, 0.7533, 0.8217, 0.8444, 0.9029, 0.9761, 1.0167, 1.0362, 1.0816,
                       1.1108, 1.1465, 1.1740, 1.1984, 1.2243, 1.2486, 1.2892, 1.3820, 1.5872, 1.7011},
                      {0.3757, 0.3748, 0.3724, 0.3649, 0.3503, 0.3273, 0.2990, 0.2885, 0.2771, 0.2478,
                       0.2156, 0.1906, 0.1676, 0.1478, 0.1311, 0.1051, 0.0790, 0.0736, 0.0657, 0.0580},
                      {0.4996, 0.6968, 0.8528, 0.9277, 1.0316, 1.1019, 1.1966, 1.2746, 1.3570, 1.4150, 1.4791, 1.5386,
                       1.5905, 1.6469, 1.6912},
                      {1.7771, 1.7865, 1.7984, 1.8031, 1.8053, 1.8372, 1.8985, 1.9304, 2.0139, 2.0950, 2.1786, 2.2425,
                       2.3187, 2.4122, 2.4761},
                      {1.357, 1.6912}};
    WaterTrial trial(setting, methods(setting.is_full ? 0.0166666667 : 0.05, 1.75));
    trial.run();
    judge_top(setting, report, trial, "three_cubes", top);
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
