// SPDX-License-Identifier: Apache-2.0
// A dam break that meets loose cubes on the floor of a flume [Canelas2016].
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

/// Changes by --full in both cases: 24 spacings per depth, the whole reservoir.
std::vector<std::string> full_version(const CaseSetting& setting) {
    if (!setting.is_full) {
        return {};
    }
    return {"fluid.spacing=0.0166666667", "fluid.domain.low=[-4.7,-0.45,-0.1]", "fluid.region.0.box.low=[-4.5,-0.35,0]",
            "body.reservoir_end.shape.half_space.offset=-4.5"};
}

}  // namespace

void dam_break_cube(const CaseSetting& setting, CaseReport& report) {
    // Digitised, between points by the straight line.
    constexpr std::array<double, 3> at{1.0, 1.25, 1.5}, measured{2.129, 2.605, 3.0735};
    WaterTrial trial(setting, full_version(setting));
    trial.run();
    const std::vector<double>& x = trial.column("cube.position.x");
    for (std::size_t i = 0; i < at.size(); ++i) {
        report.judge({fmt::format("place of the cube at {} s", at[i]), "m", measured[i], {}, "friction 0.45"},
                     interpolated(trial.time(), x, at[i]), measured[i] - 0.15, measured[i] + 0.15);
    }
    judge_ledger(report, trial);
    write_plot(
        setting, "dam_break_cube",
        {"A dam break carries a cube",
         "Canelas and others 2016",
         {"time [s]", false},
         {"x from the gate [m]", false},
         {{"measured",
           {0.1681, 0.5393, 0.65, 0.7507, 0.847, 0.9376, 1.0023, 1.0684, 1.1761, 1.2594, 1.3383, 1.4188, 1.5481},
           {1.7774, 1.8094, 1.8451, 1.8841, 1.9591, 2.0602, 2.1319, 2.2266, 2.4453, 2.6249, 2.8012, 2.9285, 3.1602},
           CurveStyle::markers,
           -1},
          {"ours", trial.time(), x, CurveStyle::line, -1}}});
}

void dam_break_cubes(const CaseSetting& setting, CaseReport& report) {
    // Of the top cube, read off the published curves of the video: height on its way down, and place when it has been
    // swept off. The bands were set before the first run.
    const std::vector<double> fall_time{0.3664, 0.7898, 0.9204, 0.9760, 1.0511, 1.0871, 1.1231, 1.1727, 1.2132, 1.2598};
    const std::vector<double> fall{0.3913, 0.3900, 0.3893, 0.3295, 0.2599, 0.2279, 0.1829, 0.1198, 0.0551, 0.0469};
    const std::vector<double> sweep_time{0.4929, 0.9027, 1.0923, 1.2026, 1.2894,
                                         1.3776, 1.4750, 1.5708, 1.6992, 1.7903};
    const std::vector<double> sweep{1.7804, 1.8272, 1.7921, 1.7721, 1.8256, 1.9071, 2.0418, 2.1893, 2.3723, 2.5147};
    WaterTrial trial(setting, full_version(setting));
    trial.run();
    const std::vector<double>&x = trial.column("top.position.x"), &z = trial.column("top.position.z");
    const std::vector<double> passes = crossings(trial.time(), z, 0.2);
    const double measured = crossings(fall_time, fall, 0.2).front();
    report.judge({"the top cube falls below 0.2 m", "s", measured, {}, "friction 0.45"},
                 passes.empty() ? std::nan("") : passes.front(), measured - 0.1, measured + 0.1);
    const auto mean_speed = [](const std::vector<double>& time, const std::vector<double>& place) {
        constexpr double start = 1.5708, end = 1.7903;
        return (interpolated(time, place, end) - interpolated(time, place, start)) / (end - start);
    };
    const double speed = mean_speed(sweep_time, sweep);
    report.judge({"its mean speed along the flume from 1.57 to 1.79 s", "m/s", speed, {}, {}},
                 mean_speed(trial.time(), x), 0.85 * speed, 1.15 * speed);
    judge_ledger(report, trial);
    write_plot(setting, "dam_break_cubes",
               {"The top cube of six in a dam break",
                "Canelas and others 2016",
                {"time [s]", false},
                {"x from the gate, height [m]", false},
                {{"height, measured", fall_time, fall, CurveStyle::markers, 0},
                 {"height, ours", trial.time(), z, CurveStyle::line, 0},
                 {"x, measured", sweep_time, sweep, CurveStyle::markers, 1},
                 {"x, ours", trial.time(), x, CurveStyle::line, 1}}});
}

}  // namespace riprap::validation::water
