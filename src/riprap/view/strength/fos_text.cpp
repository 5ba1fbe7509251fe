// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "riprap/view/strength/fos_report.hpp"

namespace riprap::view {

const TrialVerdict* FosReport::failing() const {
    const auto first = std::ranges::find_if(trials, [](const TrialVerdict& trial) { return !trial.stands; });
    return first == trials.end() ? nullptr : &*first;
}

namespace {

constexpr std::size_t most_bodies = 12;  ///< that are named

std::string strengths_of(const FosReport& report) {
    return report.reduces.empty() ? "friction, cohesion and tension"
                                  : fmt::format("{}", fmt::join(report.reduces, " and "));
}

/// Why there is no bracket, and what helps.
std::string lack_of(const FosReport& report) {
    if (report.failed == 0) {
        return fmt::format(
            "stands at F = {:.5g}, the upper end: {} divided by that much still hold it, so something else does "
            "(geometry, fixed points, locks, water) or it is far from failure; --between {:.5g} {:.5g} looks "
            "farther",
            report.stood, strengths_of(report), report.range.low, 4 * report.range.high);
    }
    return fmt::format(
        "fails at F = {:.5g}, the lower end, too: {} multiplied by {:.4g} do not hold it, so its failure is none of "
        "strength (a block that topples, a scene that has not come to rest when strength begins to fall); see the "
        "mode below, settle or --begins, or --between with a lower end",
        report.failed, strengths_of(report), 1 / report.failed);
}

std::string body_line(const BodyVerdict& body) {
    return fmt::format("  {:<20} {:<8} moved ({:.3g}, {:.3g}, {:.3g}) m, turned {:.3g} degrees\n", body.name, body.mode,
                       body.way.x, body.way.y, body.way.z, body.turned * 180 / std::numbers::pi);
}

std::string modes_of(const TrialVerdict& trial) {
    std::map<std::string, int> counts;
    std::vector<const BodyVerdict*> moving;
    for (const BodyVerdict& body : trial.bodies) {
        ++counts[body.mode];
        if (body.mode != "rests") {
            moving.push_back(&body);
        }
    }
    std::ranges::stable_sort(moving, [](const BodyVerdict* a, const BodyVerdict* b) { return a->moved > b->moved; });
    std::string text = fmt::format("mode at F = {:.5g}, where movement has begun:", trial.factor);
    for (const auto& [mode, count] : counts) {
        text += fmt::format(" {} {}{}", count, count == 1 ? "body " : "bodies ",
                            count == 1 ? mode : mode.substr(0, mode.size() - 1));
        text += mode == counts.rbegin()->first ? "\n" : ",";
    }
    for (std::size_t i = 0; i < std::min(moving.size(), most_bodies); ++i) {
        text += body_line(*moving[i]);
    }
    if (moving.size() > most_bodies) {
        text += fmt::format("  and {} more in fos_bodies.csv\n", moving.size() - most_bodies);
    }
    return text;
}

}  // namespace

std::string headline(const FosReport& report) {
    if (!report.is_found()) {
        return report.failed == 0 ? fmt::format("factor of safety above {:.5g}", report.stood)
                                  : fmt::format("factor of safety below {:.5g}", report.failed);
    }
    return fmt::format("factor of safety {:.4g}, between {:.5g} (stands) and {:.5g} (fails)", report.factor(),
                       report.stood, report.failed);
}

std::string fos_text(const FosReport& report) {
    std::string text = headline(report) + '\n';
    if (!report.is_found()) {
        text += lack_of(report) + '\n';
    }
    if (const TrialVerdict* trial = report.failing()) {
        text += modes_of(*trial);
    }
    for (const double factor : report.contradictions) {
        text += fmt::format(
            "contradiction: it stands at F = {:.5g} and fails at {:.5g}; --hold or --over longer, or "
            "another --creep, tells which\n",
            factor, report.failed);
    }
    for (const TrialVerdict& trial : report.trials) {
        for (const std::string& warning : trial.factor == report.stood ? trial.warnings : std::vector<std::string>()) {
            text += fmt::format("warned of at F = {:.5g}: {}\n", trial.factor, warning);
        }
        if (trial.factor == report.stood && trial.is_slowing) {
            text += fmt::format(
                "at F = {:.5g} bodies still slow down as the trial ends: it stands, if they come to rest; --hold "
                "{:.3g} "
                "looks on\n",
                trial.factor, 2 * report.times.hold);
        }
    }
    return text;
}

}  // namespace riprap::view
