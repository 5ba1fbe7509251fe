// SPDX-License-Identifier: Apache-2.0
// A dam break in three dimensions against a box: SPHERIC test 2 [Kleefsman2005].
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/obstacle_levels.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

/// Impact at a gauge on the face towards the water.
struct Impact {
    const char* gauge;
    double arrival;  ///< first above 500 Pa [s]
    double peak;     ///< [Pa]
    double impulse;  ///< of 0.3 to 1.2 s [Pa s]
};
constexpr std::array<Impact, 4> impacts{
    {{"P1", 0.393, 11239, 3481}, {"P2", 0.410, 8127, 2999}, {"P3", 0.423, 6564, 2944}, {"P4", 0.429, 7203, 2537}}};

void judge_impacts(const WaterTrial& trial, CaseReport& report) {
    for (const Impact& impact : impacts) {
        const std::string name = impact.gauge;
        report.judge({name + " arrival, first above 500 Pa", "s", impact.arrival, {}, {}}, trial.first_reach(name, 500),
                     impact.arrival - 0.01, impact.arrival + 0.01);
        const std::vector<double>& p = trial.column(name);
        const std::vector<double> means = running_mean(trial.time(), p, 1e-3);  // as far apart as rows of the record
        const auto two = std::upper_bound(trial.time().begin(), trial.time().end(), 2.0) - trial.time().begin();
        const double peak = *std::max_element(means.begin(), means.begin() + two);
        report.judge({name + " peak of means over 1 ms before 2 s", "Pa", impact.peak, {}, {}}, peak,
                     0.85 * impact.peak, 1.15 * impact.peak);
        report.judge({name + " impulse from 0.3 to 1.2 s", "Pa s", impact.impulse, {}, {}},
                     integral(trial.time(), p, 0.3, 1.2), 0.9 * impact.impulse, 1.1 * impact.impulse);
    }
}

/// Judges the heights at every gauge from the time at which the experiment has water there. The band is a share of the
/// measured height; beside it stands the band of the data's own measure, 3 % of the depth for the two gauges it names.
void judge_heights(const WaterTrial& trial, CaseReport& report, Plot& plot) {
    constexpr double depth = 0.55;
    int color = 0;
    for (const ObstacleLevels& measured : obstacle_levels) {
        const std::vector<double>& level = trial.column(measured.gauge);
        std::vector<double> time, height;
        double error = 0, sum = 0;
        for (std::size_t i = 0; i < measured.height.size(); ++i) {
            const double t = 0.5 * static_cast<double>(i + 1);
            if (t > measured.arrival) {
                time.push_back(t);
                height.push_back(measured.height[i]);
                error += std::abs(interpolated(trial.time(), level, t) - measured.height[i]);
                sum += measured.height[i];
            }
        }
        report.judge_below({fmt::format("{}: mean error to 6 s over the mean height measured", measured.gauge),
                            "-",
                            {},
                            0.0,
                            fmt::format("every 0.5 s from {:.1f} s", time.front())},
                           error / sum, 0.05);
        if (measured.is_named) {
            report.judge_below({fmt::format("{}: mean error to 6 s over the depth", measured.gauge), "-", {}, 0.0, {}},
                               error / static_cast<double>(time.size()) / depth, 0.03);
        }
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
