// SPDX-License-Identifier: Apache-2.0
// Bodies that water lets sink, stops or carries away.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

/// Penetration over D against t sqrt(g/D).
struct Entry {
    double density;
    std::vector<double> time, measured;  ///< [Greenhow1983]
    std::vector<double> bem_time, bem;   ///< boundary elements, as published with it
};

const std::array<Entry, 2>& entries() {
    static const std::array<Entry, 2> all{{
        {1000, {0.1378, 0.8429, 1.0321, 1.8814}, {0.4010, 1.6823, 2.0104, 2.7240}, {0.4487, 0.9679}, {0.8906, 1.6979}},
        {500,
         {0.0000, 0.1004, 0.2773, 0.3777, 0.7969, 1.1310},
         {0.0024, 0.1683, 0.4954, 0.6094, 1.0676, 1.2205},
         {0.5044, 0.9847},
         {0.7683, 1.2671}},
    }};
    return all;
}

/// Largest residual of the momentum ledgers over `scale` [-].
double momentum_gap(const WaterTrial& trial, double scale) {
    const sim::Ledger& ledger = trial.report().ledger;
    return (norm(ledger.momentum_residual) + norm(ledger.fluid.momentum_residual)) / scale;
}

}  // namespace

void cylinder_entry(const CaseSetting& setting, CaseReport& report) {
    constexpr double diameter = 0.11, level = 0.3, speed = 2.955;
    const double unit = std::sqrt(diameter / 9.81);
    Plot plot{"A cylinder falls into water",
              "Greenhow and Lin 1983",
              {"t sqrt(g/D) [-]", false},
              {"penetration/D [-]", false},
              {},
              false};
    for (const Entry& entry : entries()) {
        std::vector<std::string> overrides{fmt::format("body.cylinder.density={}", entry.density)};
        if (setting.is_full) {
            overrides.emplace_back("fluid.spacing=0.00375");
        }
        WaterTrial trial(setting, overrides);
        trial.run();
        std::vector<double> time{0}, depth{0};
        for (std::size_t i = 0; i < trial.time().size(); ++i) {
            time.push_back(trial.time()[i] / unit);
            depth.push_back((level - trial.column("cylinder.position.y")[i]) / diameter + 0.5);
        }
        const std::string name = fmt::format("density {}", entry.density);
        double worst = 0, worst_bem = 0;
        for (std::size_t i = 0; i < entry.time.size(); ++i) {
            worst = std::max(worst, std::abs(interpolated(time, depth, entry.time[i]) - entry.measured[i]));
        }
        for (std::size_t i = 0; i < entry.bem.size(); ++i) {
            worst_bem = std::max(worst_bem, std::abs(interpolated(time, depth, entry.bem_time[i]) / entry.bem[i] - 1));
        }
        report.judge_below({name + ": largest error of the penetration over D", "-", {}, 0.0, "measured"}, worst, 0.08);
        report.judge_below({name + ": largest relative error up to time 1", "-", {}, 0.0, "boundary elements"},
                           worst_bem, 0.05);
        const double area = 0.25 * M_PI * diameter * diameter;
        report.judge_below(
            {name + ": momentum that the ledgers miss over that of the cylinder", "-", {}, 0.0, {}, Kind::bookkeeping},
            momentum_gap(trial, entry.density * area * speed), 1e-3);
        judge_ledger(report, trial, name);
        plot.curves.push_back({name + ", measured", entry.time, entry.measured, CurveStyle::markers, -1});
        plot.curves.push_back({name + ", ours", time, depth, CurveStyle::line, -1});
    }
    write_plot(setting, "cylinder_entry", plot);
}

void sinking_block(const CaseSetting& setting, CaseReport& report) {
    const std::vector<double> time{0.0367, 0.0781, 0.1195, 0.1585, 0.1991, 0.2406, 0.2804};
    const std::vector<double> measured{0.12816, 0.12140, 0.11227, 0.10010, 0.08454, 0.06831, 0.05005};
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.0025"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    const std::vector<double>& z = trial.column("block.position.z");
    double worst = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        worst = std::max(worst, std::abs(interpolated(trial.time(), z, time[i]) - measured[i]));
    }
    report.judge_below({"largest error of its height up to 0.28 s", "m", {}, 0.0, "Qiu and others 2017"}, worst, 5e-3);
    const std::vector<double> passes = crossings(trial.time(), z, 0.05);
    report.judge({"passes 0.05 m", "s", 0.281, {}, {}}, passes.empty() ? std::nan("") : passes.front(), 0.95 * 0.281,
                 1.05 * 0.281);
    judge_ledger(report, trial);
    write_plot(
        setting, "sinking_block",
        {"A block sinks",
         "Qiu and others 2017",
         {"time [s]", false},
         {"height of its centre [m]", false},
         {{"measured", time, measured, CurveStyle::markers, -1}, {"ours", trial.time(), z, CurveStyle::line, -1}}});
}

}  // namespace riprap::validation::water
