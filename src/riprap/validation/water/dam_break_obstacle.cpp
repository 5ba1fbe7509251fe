// SPDX-License-Identifier: Apache-2.0
// A dam break in three dimensions against a box: SPHERIC test 2 [Kleefsman2005].
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

/// Of a gauge on the face towards the water.
struct Impact {
    const char* gauge;
    double arrival;  ///< first above 500 Pa [s]
    double peak;     ///< [Pa]
    double impulse;  ///< of 0.3 to 1.2 s [Pa s]
};
constexpr std::array<Impact, 4> impacts{
    {{"P1", 0.393, 11239, 3481}, {"P2", 0.410, 8127, 2999}, {"P3", 0.423, 6564, 2944}, {"P4", 0.429, 7203, 2537}}};

/// Heights of water [m] every quarter of a second from 0.25 to 2 s.
struct Heights {
    const char* gauge;
    std::array<double, 8> height;
};
constexpr std::array<Heights, 4> heights{{
    {"level_2638", {{0.5, 0.426, 0.347, 0.279, 0.223, 0.182, 0.153, 0.13}}},
    {"level_1488", {{0.05, 0.095, 0.129, 0.154, 0.157, 0.145, 0.131, 0.142}}},
    {"level_992", {{0.001, 0.099, 0.14, 0.179, 0.201, 0.236, 0.321, 0.287}}},
    {"level_496", {{0.001, 0.001, 0.002, 0.151, 0.27, 0.346, 0.323, 0.288}}},
}};

/// Rows of those before water comes back from the far wall: the record has it at x = 0.496 m after 0.918 s.
constexpr std::size_t rows_before_reflection = 3;

void judge_impacts(const WaterTrial& trial, CaseReport& report) {
    for (const Impact& impact : impacts) {
        const std::string name = impact.gauge;
        report.judge({name + " arrival, first above 500 Pa", "s", impact.arrival, {}, {}}, trial.first_reach(name, 500),
                     impact.arrival - 0.01, impact.arrival + 0.01);
        const std::vector<double>& p = trial.column(name);
        const std::vector<double> means = running_mean(trial.time(), p, 1e-3);  // as far apart as rows of the record
        report.judge({name + " peak of means over 1 ms", "Pa", impact.peak, {}, {}},
                     *std::max_element(means.begin(), means.end()), 0.85 * impact.peak, 1.15 * impact.peak);
        report.judge({name + " impulse from 0.3 to 1.2 s", "Pa s", impact.impulse, {}, {}},
                     integral(trial.time(), p, 0.3, 1.2), 0.9 * impact.impulse, 1.1 * impact.impulse);
    }
}

void judge_heights(const WaterTrial& trial, CaseReport& report, Plot& plot) {
    constexpr double depth = 0.55;
    int color = 0;
    for (const Heights& measured : heights) {
        const std::vector<double>& level = trial.column(measured.gauge);
        std::vector<double> time, height;
        double sum = 0, before = 0;
        for (std::size_t i = 0; i < measured.height.size(); ++i) {
            time.push_back(0.25 * static_cast<double>(i + 1));
            height.push_back(measured.height[i]);
            sum += std::abs(interpolated(trial.time(), level, time.back()) - height.back());
            before = i < rows_before_reflection ? sum : before;
        }
        report.judge_below(
            {fmt::format("{}: mean error over the depth, 0.25 to 0.75 s, before the first reflection", measured.gauge),
             "-",
             {},
             0.0,
             {}},
            before / static_cast<double>(rows_before_reflection) / depth, 0.05);
        report.judge_below(
            {fmt::format("{}: mean error over the depth, 0.25 to 2 s", measured.gauge), "-", {}, 0.0, {}},
            sum / static_cast<double>(time.size()) / depth, 0.05);
        plot.curves.push_back({fmt::format("{} measured", measured.gauge), time, height, CurveStyle::markers, color});
        plot.curves.push_back({"ours", trial.time(), level, CurveStyle::line, color++});
    }
}

}  // namespace

void dam_break_obstacle(const CaseSetting& setting, CaseReport& report) {
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.0125"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    Plot plot{"Height of water in a dam break against a box",
              "SPHERIC test 2",
              {"time [s]", false},
              {"height [m]", false},
              {},
              false};
    judge_impacts(trial, report);
    judge_heights(trial, report, plot);
    judge_ledger(report, trial);
    write_plot(setting, "dam_break_obstacle_heights", plot);
    Plot pressures{"Pressure on the box", "SPHERIC test 2", {"time [s]", false}, {"pressure [Pa]", false}, {}, false};
    for (const Impact& impact : impacts) {
        pressures.curves.push_back({impact.gauge, trial.time(), trial.column(impact.gauge), CurveStyle::line, -1});
    }
    write_plot(setting, "dam_break_obstacle_pressures", pressures);
}

}  // namespace riprap::validation::water
