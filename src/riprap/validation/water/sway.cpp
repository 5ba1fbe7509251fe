// SPDX-License-Identifier: Apache-2.0
// Breaking waves in shallow water that sways with its tank [Bouscasse2013].
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double depth = 0.03, period = 2.99929;  ///< of case.toml [m], [s]

/// t/T - 9 and the surface above its rest [m], 5 cm from the left wall, in the tenth period of the record: every other
/// point of its slow part, all of the crest. At t = 0 the tank passes its middle, to the right, in the source too.
constexpr std::array<std::array<double, 2>, 27> measured{
    {{0.439, -0.008}, {0.521, -0.008}, {0.608, -0.011}, {0.691, -0.009}, {0.736, -0.008}, {0.769, -0.004},
     {0.777, 0.003},  {0.789, 0.008},  {0.810, 0.015},  {0.837, 0.026},  {0.848, 0.034},  {0.858, 0.041},
     {0.864, 0.056},  {0.876, 0.060},  {0.893, 0.052},  {0.914, 0.040},  {0.957, 0.033},  {0.977, 0.037},
     {1.013, 0.031},  {1.059, 0.023},  {1.098, 0.019},  {1.154, 0.012},  {1.181, 0.005},  {1.217, 0.003},
     {1.255, -0.001}, {1.332, -0.005}, {1.414, -0.007}}};
/// Mean of the three crests of the record: 56, 60 and 59 mm at 0.884, 0.876 and 0.869 of a period.
constexpr double measured_crest = 0.0583, measured_phase = 0.876;

/// The highest row from n + 0.4 to n + 1.4 periods; its time in periods since n.
Crest crest_of_period(const WaterTrial& trial, int n) {
    const std::vector<double>& level = trial.column("level");
    Crest crest{0, -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < level.size(); ++i) {
        const double turns = trial.time()[i] / period - n;
        if (turns >= 0.4 && turns < 1.4 && level[i] - depth > crest.level) {
            crest = {turns, level[i] - depth};  // bores are a few rows long: no parabola
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
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr int first = 8, count = 3;  // periods that were measured
    double height = 0, phase = 0, lowest = infinity, highest = -infinity, trough = infinity;
    for (int n = first; n < first + count; ++n) {
        const Crest crest = crest_of_period(trial, n);
        height += crest.level / count;
        phase += crest.time / count;
        lowest = std::min(lowest, crest.level);
        highest = std::max(highest, crest.level);
    }
    report.judge({"height of the crest, mean of periods", "m", measured_crest, {}, {}}, height, 0.9 * measured_crest,
                 1.1 * measured_crest);
    report.judge({"height of the lowest crest", "m", 0.056, {}, "of three periods measured"}, lowest, 0.9 * 0.056,
                 1.1 * 0.056);
    report.judge({"height of the highest crest", "m", 0.060, {}, "of three periods measured"}, highest, 0.9 * 0.060,
                 1.1 * 0.060);
    report.judge({"its phase", "period", measured_phase, {}, {}}, phase, measured_phase - 0.03, measured_phase + 0.03);
    std::vector<double> turns, level;  // of the period that the picture shows
    for (std::size_t i = 0; i < trial.time().size(); ++i) {
        const double turn = trial.time()[i] / period, above = trial.column("level")[i] - depth;
        trough = turn >= first + 0.4 ? std::min(trough, above) : trough;
        if (turn >= 9.4 && turn < 10.4) {
            turns.push_back(turn - 9);
            level.push_back(above);
        }
    }
    report.judge({"lowest level", "m", -0.011, {}, "of three periods measured"}, trough, -1.1 * 0.011, -0.9 * 0.011);
    judge_ledger(report, trial);
    std::vector<double> their_turns, their_level;
    for (const auto& [turn, above] : measured) {
        their_turns.push_back(turn);
        their_level.push_back(above);
    }
    write_plot(setting, "sway",
               {"Surface 5 cm from the end of a swaying tank",
                "Bouscasse and others 2013, series 5; from 9.4 to 10.4 periods",
                {"t/T - 9 [-]", false},
                {"surface above its rest [m]", false},
                {{"measured", their_turns, their_level, CurveStyle::markers, -1},
                 {"ours", turns, level, CurveStyle::line, -1}}});
}

}  // namespace riprap::validation::water
