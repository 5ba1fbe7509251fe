// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "riprap/validation/case_trial.hpp"
#include "riprap/validation/zhao/cases.hpp"
#include "riprap/validation/zhao/tilt.hpp"

namespace riprap::validation::zhao {

namespace {

constexpr double approach_margin = 4;  // below the accepted band, where the slow turn takes over [deg]

/// One of the five slopes: what is published, and what the mechanics of its blocks allow.
struct Slope {
    double paper, li;                        ///< simulated failure angle of Zhao and of Li [deg]
    double experiment_low, experiment_high;  ///< [deg]
    double low, high;                        ///< accepted [deg]
    const char* reason;                      ///< of the accepted band
    bool topples;                            ///< published mode
    double approach() const { return low - approach_margin; }
};

void judge(const CaseSetting& setting, const Slope& slope, CaseReport& report) {
    const Failures failures = tilt_until_failure(setting, trial_of(setting), slope.approach());
    const Failure &held = failures.held, &turned = failures.turned;
    const auto published = fmt::format("{} (experiment {} to {}, Li {})", slope.paper, slope.experiment_low,
                                       slope.experiment_high, slope.li);
    report.judge({"failure angle, held at every 0.1 deg", "deg", published, {}, slope.reason},
                 held.collapsed ? held.angle : std::nan(""), slope.low, slope.high);
    report.judge({"the same against the experiment", "deg", published, {}, "experiment: the range of its repeats"},
                 held.collapsed ? held.angle : std::nan(""), slope.experiment_low, slope.experiment_high);
    constexpr double paper_step = 1;  // degrees, the last digit that the paper gives
    report.judge({"angle at 1 mm, turned at 0.03 rad/s",
                  "deg",
                  published,
                  {},
                  fmt::format("late by the time that 1 mm takes: {:.2f} deg", lag_of_failure(slope.topples))},
                 turned.collapsed ? turned.angle : std::nan(""), slope.paper - paper_step, slope.paper + paper_step);
    report.judge({"share of the moving mass that topples", "-", slope.topples ? "toppling" : "sliding", {}, {}},
                 turned.collapsed ? turned.toppling_share : std::nan(""), slope.topples ? 0.5 : 0.0,
                 slope.topples ? 1.0 : 0.5);
    // inscribed radius = half the height of a block
    report.judge_below({"deepest overlap after settling over block size", "-", {}, {}, {}}, 0.5 * failures.rest_depth,
                       1e-4);
    report.judge_below({"largest displacement before the slow turn", "m", {}, {}, {}}, failures.approach_slip,
                       0.5 * failure_slip);
}

}  // namespace

void slope_1(const CaseSetting& setting, CaseReport& report) {
    judge(setting, {24.0, 23.0, 22.1, 24.2, 22, 25, "free column 21.8, static bound of the profile 24.0", true},
          report);
}
void slope_2(const CaseSetting& setting, CaseReport& report) {
    judge(setting, {26.0, 25.5, 25.0, 26.3, 25.9, 26.5, "friction angle 26.0 -0.1 +0.5", false}, report);
}
void slope_3(const CaseSetting& setting, CaseReport& report) {
    judge(setting, {11.0, 10.0, 9.8, 11.6, 11.0, 14.3, "free column 11.31, static bound 14.26", true}, report);
}
void slope_4(const CaseSetting& setting, CaseReport& report) {
    judge(setting, {24.0, 23.5, 23.0, 24.9, 25.9, 26.5, "friction angle 26.0 -0.1 +0.5; no mechanism is weaker", false},
          report);
}
void slope_5(const CaseSetting& setting, CaseReport& report) {
    judge(setting,
          {21.0, 20.0, 19.5, 21.8, 19.5, 22.5,
           "these blocks: limit equilibrium 16 to 20, static bound 20.8; see the page of slope_5", false},
          report);
}

}  // namespace riprap::validation::zhao
