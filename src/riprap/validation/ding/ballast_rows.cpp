// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/ding/ballast_rows.hpp"

#include <algorithm>

namespace riprap::validation::ding {

std::vector<BallastBed> beds_of(const CaseSetting& setting, double length, double thickness, std::uint64_t count) {
    std::vector<BallastBed> beds;
    for (std::uint64_t seed = 1; seed <= (setting.is_full ? 5u : count); ++seed) {
        beds.push_back(make_bed(length, setting.is_full ? 0.35 : thickness, seed));
    }
    return beds;
}

std::vector<Strike> strikes_of(const std::vector<BallastBed>& beds, const Shot& shot) {
    std::vector<Strike> strikes;
    for (const BallastBed& bed : beds) {
        strikes.push_back(strike(bed, shot));
    }
    return strikes;
}

Mean mean_of(const std::vector<Strike>& strikes) {
    Mean mean;
    const double share = 1.0 / static_cast<double>(strikes.size());
    for (const Strike& one : strikes) {
        mean.flying += share * one.flying;
        mean.above_330 += share * one.above_330;
        mean.highest += share * one.highest;
        mean.marked_x += share * one.marked.x;
        mean.marked_y += share * one.marked.y;
        mean.ice_way += share * one.ice_way;
        mean.ice_bounce += share * one.ice_bounce;
        mean.ice_angle += share * one.ice_angle;
        mean.crater_depth += share * one.crater_depth;
        mean.crater_width += share * one.crater_width;
        mean.marked_apex += share * one.marked_apex;
        mean.impact_time += share * one.impact_time;
        mean.rail += share * (one.has_hit_rail ? 1 : 0);
        mean.parabola = std::max(mean.parabola, one.parabola);
        mean.ledger = std::max(mean.ledger, one.ledger);
    }
    return mean;
}

void judge_yes(CaseReport& report, const std::string& what, const char* paper, bool is_so) {
    report.judge({what + " (1 = yes)", "-", paper, 1.0, {}}, is_so ? 1 : 0, 1, 1);
}

Plot paths(const std::string& title) {
    Plot plot;
    plot.title = title;
    plot.subtitle = "lines: ice, from its touch; markers: the stone that it meets first";
    plot.x.label = "time from the touch [s]";
    plot.y.label = "displacement [m]";
    return plot;
}

void add_paths(Plot& plot, const std::string& label, const Strike& strike) {
    const int color = static_cast<int>(plot.curves.size() / 2);
    plot.curves.push_back({label, strike.times, strike.ice_ways, CurveStyle::line, color});
    plot.curves.push_back({label + ", stone", strike.times, strike.marked_ways, CurveStyle::markers, color});
}

void report_bed(CaseReport& report, const std::vector<BallastBed>& beds) {
    report.state({"stones in the bed", "-", {}}, beds.front().stone_count);
    report.state({"porosity of the bed", "-", "the paper says: completely compacted"}, beds.front().porosity);
}

void report_ledger(CaseReport& report, double ledger) {
    report.judge_below(
        {"energy that the ledger misses, over its turnover, worst run", "-", {}, 0.0, {}, Kind::bookkeeping}, ledger,
        0.01);
}

}  // namespace riprap::validation::ding
