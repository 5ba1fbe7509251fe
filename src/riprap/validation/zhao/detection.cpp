// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "riprap/bench/broadphase.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/validation/zhao/cases.hpp"

namespace riprap::validation::zhao {

namespace {

using bench::Search;

Curve curve_of(const char* label, std::span<const std::int32_t> counts, const std::vector<double>& times,
               CurveStyle style) {
    Curve curve{label, {}, {}, style, -1};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        curve.x.push_back(counts[i]);
        curve.y.push_back(1e3 * 10 * times[i]);  // the paper's figures show ten detections
    }
    return curve;
}

}  // namespace

void detection(const CaseSetting& setting, CaseReport& report) {
    const bench::ThreadScope one(1);
    constexpr std::array paper_counts{1000, 2000, 3000, 4000, 5000, 6000};
    constexpr std::array counts{1000, 2000, 5000, 10'000, 20'000, 50'000, 100'000};
    const std::vector<double> ours = search_times(Search::multilevel_grid, paper_counts);
    const std::vector<double> single = search_times(Search::single_grid, paper_counts);
    report.judge({"slope of log time against log N, 1000 to 100 000", "-", std::string("linear"), 1.0, {}},
                 bench::log_log_slope(counts, search_times(Search::multilevel_grid, counts)), 0, 1.1);
    constexpr double without_end = 1e9;
    report.judge(
        {"slope of log time against log N, 1000 to 6000", "-", std::string("linear"), 1.0, "the paper's range"},
        bench::log_log_slope(paper_counts, ours), 0, 1.1);
    report.judge({"the same with a single grid",
                  "-",
                  std::string("not linear"),
                  {},
                  "at constant density and mix a single grid is linear too; only its constant grows"},
                 bench::log_log_slope(paper_counts, single), 1.1, without_end);
    report.judge({"time of a single grid over that of the levels, 6000 blocks", "-", std::string("slower"), {}, {}},
                 single.back() / ours.back(), 1, without_end);

    Plot plot;
    plot.title = "Ten searches for candidate pairs against the number of blocks";
    plot.subtitle = "a tenth of the blocks ten times the size of the others, constant density, one thread";
    plot.x.label = "blocks [-]";
    plot.y.label = "processor time [ms]";
    plot.curves = {curve_of("levels", paper_counts, ours, CurveStyle::line),
                   curve_of("single grid", paper_counts, single, CurveStyle::line)};
    write_plot(setting, "detection_time", plot);
}

}  // namespace riprap::validation::zhao
