// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/validation/ding/planar_ballast.hpp"

// Rows and curves that all cases with ice on ballast have.

namespace riprap::validation::ding {

constexpr double kmh = 1 / 3.6;  ///< [m/s]

/// Makes the packings of a case: `count`, or five in the long version.
std::vector<BallastBed> beds_of(const CaseSetting& setting, double length, double thickness, std::uint64_t count = 1);

/// Means over the packings; of parabola and ledger the worst.
struct Mean {
    double flying{0}, above_330{0}, highest{0}, marked_x{0}, marked_y{0}, ice_way{0}, ice_bounce{0}, rail{0};
    double marked_apex{0};
    double impact_time{0}, parabola{0}, ledger{0}, ice_angle{0}, crater_depth{0}, crater_width{0};
};
Mean mean_of(const std::vector<Strike>& strikes);

/// Throws the same ice on every packing.
std::vector<Strike> strikes_of(const std::vector<BallastBed>& beds, const Shot& shot);

/// Judges the share of packings in which something holds. The source's orderings are those of single packings, of which
/// four of five have to agree.
template <class Holds>
void judge_share(CaseReport& report, const std::string& what, const char* paper, std::size_t packings,
                 const Holds& holds) {
    double share = 0;
    for (std::size_t k = 0; k < packings; ++k) {
        share += holds(k) ? 1.0 / static_cast<double>(packings) : 0;
    }
    report.judge({"share of packings in which " + what, "-", paper, 1.0, {}}, share, 0.8 - 1e-9, 1);
}

void judge_yes(CaseReport& report, const std::string& what, const char* paper, bool is_so);

/// Displacements of ice and marked stone against time, of the first packing of each shot.
Plot paths(const std::string& title);
void add_paths(Plot& plot, const std::string& label, const Strike& strike);

void report_bed(CaseReport& report, const std::vector<BallastBed>& beds);
void report_ledger(CaseReport& report, double ledger);

}  // namespace riprap::validation::ding
