// SPDX-License-Identifier: Apache-2.0
// The tower of three cubes in a dam break [Canelas2016], spheres for cubes and MPS for SPH.
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

std::vector<std::string> methods(double spacing, double end) {
    return {"fluid.method=\"wcmps\"",           "fluid.smoothing_ratio=1.05",  "fluid.weight=\"reciprocal\"",
            "fluid.wall_pressure=\"mirrored\"", "solid.method=\"sphere_dem\"", fmt::format("fluid.spacing={}", spacing),
            fmt::format("end={}", end)};
}

}  // namespace

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

}  // namespace riprap::validation::mellado
