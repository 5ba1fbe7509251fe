// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/mikola/cases.hpp"
#include "riprap/validation/mikola/water_run.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::mikola {

namespace {

constexpr double gravity = 9.81, water = 1000;

/// What a body falling through water did: how far and how fast, at every time.
struct Fall {
    std::vector<double> time, way, speed;  ///< [s], downwards [m], [m/s]

    void add(const Trial& trial, BodyId body, double start) {
        time.push_back(trial.time());
        way.push_back(start - trial.position(body).y);
        speed.push_back(-trial.velocity(body).y);
    }
    /// Speed when it has first gone so far, on a straight line between rows; NaN where it never does [m/s].
    double speed_at(double distance) const {
        const auto first = std::find_if(way.begin(), way.end(), [&](double s) { return s >= distance; });
        const auto i = static_cast<std::size_t>(first - way.begin());
        if (i == 0 || i == way.size()) {
            return std::nan("");
        }
        const double share = (distance - way[i - 1]) / (way[i] - way[i - 1]);
        return speed[i - 1] + share * (speed[i] - speed[i - 1]);
    }
    /// 2 s/t^2 at the row nearest to `at`, along a slope of `angle` [m/s^2].
    double acceleration(double at, double angle) const {
        const auto after = std::lower_bound(time.begin(), time.end(), at - 1e-9);
        const auto i = static_cast<std::size_t>(after - time.begin());
        return 2 * way.at(i) / std::sin(angle) / (time[i] * time[i]);
    }
};

Fall follow(const CaseSetting& setting, CaseReport& report, const std::string& name, Trial& trial,
            WaterRecords& records) {
    const BodyId body = trial.body(name);
    const double start = trial.position(body).y, spacing = trial.model().particles()->settings().spacing;
    Fall fall;
    int inside = 0;
    run_water(trial, records, trial.model().time.end, 0.01, [&](const Trial& now) {
        fall.add(now, body, start);
        inside = std::max(inside, count_inside_solids(now, 0.5 * spacing));
    });
    write_plot(setting, setting.folder.filename().string() + "_end",
               water_view(trial, fmt::format("{} at {:.2f} s", name, trial.time())));
    report.judge_below(
        {"most particles at a time more than half a spacing inside a solid", "-", {}, {}, {}, Kind::bookkeeping},
        inside, 0);
    judge_ledgers(report, name, records);
    return fall;
}

}  // namespace

void submarine_wedge(const CaseSetting& setting, CaseReport& report) {
    constexpr double angle = M_PI / 4, density = 2000;
    const auto with_added = [](double added) {
        return (density - water) / (density + added * water) * gravity * std::sin(angle);
    };
    Trial trial = trial_of(setting);
    const auto wedge = static_cast<std::size_t>(trial.body("wedge").value);
    report.judge({"mass of the wedge", "kg/m", 0.5 * 0.5 * 0.5 * density, {}, "half a square of 0.5 m, 2000 kg/m^3"},
                 trial.model().bodies.mass[wedge], 0.99 * 0.125 * density, 1.01 * 0.125 * density);
    WaterRecords records;
    const Fall fall = follow(setting, report, "wedge", trial, records);
    report.judge({"2 s/t^2 at 0.2 s", "m/s^2", {}, {}, "added mass between none and 1.0"},
                 fall.acceleration(0.2, angle), with_added(1), with_added(0));
    report.judge(
        {"vertical speed after 0.44 m", "m/s", 0.6, {}, "the limit that it tends to in the experiment, on rollers"},
        fall.speed_at(0.44), 0.9 * 0.6, 1.1 * 0.6);
}

void scott_russell(const CaseSetting& setting, CaseReport& report) {
    constexpr double depth = 0.21, foot = depth - 0.005;  // foot of the box above the bottom at the start
    Trial trial = trial_of(setting);
    WaterRecords records;
    const Fall fall = follow(setting, report, "box", trial, records);
    for (const double share : {0.8, 2.0 / 3, 0.4}) {  // Y/D, foot of the box above the bottom
        const double exact = 1.03 * share * std::sqrt(1 - share) * std::sqrt(gravity * depth);
        report.judge({fmt::format("speed of the box at Y/D = {:.3g}", share), "m/s", {}, exact, {}},
                     fall.speed_at(foot - share * depth), Relative{0.1});
    }
    const water::Crest near = water::crest_of(records.time, records.gauge[0]),
                       far = water::crest_of(records.time, records.gauge[1]);
    report.judge({"crest 1.2 m from the end wall", "m", 0.11, {}, "the measured figure is not certain"},
                 near.level - depth, 0.9 * 0.11, 1.1 * 0.11);
    const double mean = 0.5 * (near.level + far.level) - depth;
    report.judge({"celerity of the crest between 1.2 and 2.2 m",
                  "m/s",
                  {},
                  std::sqrt(gravity * (depth + mean)),
                  "of a solitary wave of the mean height of our crest"},
                 1 / (far.time - near.time), Relative{0.03});
}

}  // namespace riprap::validation::mikola
