// SPDX-License-Identifier: Apache-2.0
// Breaking waves in shallow water that sways with its tank [Bouscasse2013].
#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double depth = 0.03, period = 2.99929;  ///< of case.toml [m], [s]

/// The record from half way before a crest to half way after it: t/T from the middle of the tank's way to the right on,
/// and the surface above its rest, 5 cm from the left wall [m]. The tenth period of the record.
const std::vector<double> measured_time{0.439, 0.521, 0.608, 0.691, 0.736, 0.769, 0.777, 0.789, 0.810,
                                        0.837, 0.848, 0.858, 0.864, 0.876, 0.893, 0.914, 0.957, 0.977,
                                        1.013, 1.059, 1.098, 1.154, 1.181, 1.217, 1.255, 1.332, 1.414};
const std::vector<double> measured_level{-0.008, -0.008, -0.011, -0.009, -0.008, -0.004, 0.003,  0.008,  0.015,
                                         0.026,  0.034,  0.041,  0.056,  0.060,  0.052,  0.040,  0.033,  0.037,
                                         0.031,  0.023,  0.019,  0.012,  0.005,  0.003,  -0.001, -0.005, -0.007};
/// Mean of the three crests of the record: 56, 60 and 59 mm at 0.884, 0.876 and 0.869 of a period.
constexpr double measured_crest = 0.0583, measured_phase = 0.876;

/// The highest row of the period that begins at 0.4 of period `n`.
Crest crest_of_period(const WaterTrial& trial, int n) {
    const std::vector<double>& level = trial.column("level");
    Crest crest{0, -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < level.size(); ++i) {
        const double turns = trial.time()[i] / period;
        if (turns >= n + 0.4 && turns < n + 1.4 && level[i] - depth > crest.level) {
            crest = {turns - n, level[i] - depth};
        }
    }
    return crest;
}

}  // namespace

void sway(const CaseSetting& setting, CaseReport& report) {
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.002"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    constexpr int first = 8, whole = 11;  // periods that were measured
    double height = 0, phase = 0, lowest = 1, highest = 0, trough = 0;
    for (int n = first; n < whole; ++n) {
        const Crest crest = crest_of_period(trial, n);
        height += crest.level / (whole - first);
        phase += crest.time / (whole - first);
        lowest = std::min(lowest, crest.level);
        highest = std::max(highest, crest.level);
    }
    report.judge({"height of the crest, mean of periods", "m", measured_crest, {}, {}}, height, 0.9 * measured_crest,
                 1.1 * measured_crest);
    report.state({"height of the lowest crest", "m", 0.056, {}, "of three periods measured"}, lowest);
    report.state({"height of the highest crest", "m", 0.060, {}, "of three periods measured"}, highest);
    report.judge({"its phase", "period", measured_phase, {}, {}}, phase, measured_phase - 0.03, measured_phase + 0.03);
    judge_ledger(report, trial);
    for (std::size_t i = 0; i < trial.time().size(); ++i) {
        if (trial.time()[i] >= (first + 0.4) * period) {
            trough = std::min(trough, trial.column("level")[i] - depth);
        }
    }
    report.state({"lowest level", "m", -0.011, {}, "of three periods measured"}, trough);
    std::vector<double> turns, level;
    for (std::size_t i = 0; i < trial.time().size(); ++i) {
        const double turn = trial.time()[i] / period - (whole - 1);
        if (turn >= 0.4 && turn < 1.4) {
            turns.push_back(turn);
            level.push_back(trial.column("level")[i] - depth);
        }
    }
    write_plot(setting, "sway",
               {"Surface 5 cm from the end of a swaying tank",
                "Bouscasse and others 2013, series 5; the last period that is whole",
                {"t/T [-]", false},
                {"surface above its rest [m]", false},
                {{"measured", measured_time, measured_level, CurveStyle::markers, -1},
                 {"ours", turns, level, CurveStyle::line, -1}}});
}

}  // namespace riprap::validation::water
