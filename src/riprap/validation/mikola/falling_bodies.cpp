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

/// Motion of a body that falls through water: depth and speed at every time.
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

/// Runs the case to its end. @param run  what its rows and its picture are called
Fall follow(const CaseSetting& setting, CaseReport& report, const std::string& name, const std::string& run,
            Trial& trial, WaterRecords& records) {
    const BodyId body = trial.body(name);
    const double start = trial.position(body).y, spacing = trial.model().particles()->settings().spacing;
    Fall fall;
    int inside = 0;
    run_water(trial, records, trial.model().time.end, 0.01, [&](const Trial& now) {
        fall.add(now, body, start);
        inside = std::max(inside, count_inside_solids(now, 0.5 * spacing));
    });
    write_plot(setting, fmt::format("{}_{}_end", setting.folder.filename().string(), run),
               water_view(trial, fmt::format("{}: {} at {:.2f} s", run, name, trial.time())));
    report.judge_below({run + ": most particles at a time more than half a spacing inside a solid",
                        "-",
                        {},
                        {},
                        {},
                        Kind::bookkeeping},
                       inside, 0);
    judge_ledgers(report, run, records);
    return fall;
}

/// One depth of Monaghan and Kos: speeds of the box on its way, height and celerity of the wave.
void judge_generator(const CaseSetting& setting, double depth, double measured, CaseReport& report) {
    constexpr double dip = 0.005, box_height = 0.4;  // [m]; the foot of the box starts under water
    const std::vector<std::string> overrides{fmt::format("fluid.region.0.box.high=[4.0,{}]", depth),
                                             fmt::format("fluid.region.0.level={}", depth),
                                             fmt::format("body.box.position=[0.15,{}]", depth - dip + box_height / 2)};
    Trial trial = trial_of(setting, overrides);
    WaterRecords records;
    const std::string run = fmt::format("depth {:.0f} mm", 1000 * depth);
    const Fall fall = follow(setting, report, "box", run, trial, records);
    for (const double share : {0.8, 2.0 / 3, 0.4}) {  // Y/D, foot of the box above the bottom
        const double exact = 1.03 * share * std::sqrt(1 - share) * std::sqrt(gravity * depth);
        report.judge({fmt::format("{}: speed of the box at Y/D = {:.3g}", run, share), "m/s", {}, exact, {}},
                     fall.speed_at(depth - dip - share * depth), Relative{0.1});
    }
    const water::Crest near = water::crest_of(records.time, records.gauge[0]),
                       far = water::crest_of(records.time, records.gauge[1]);
    report.judge({run + ": crest 1.2 m from the end wall", "m", measured, {}, "the measured figure is not certain"},
                 near.level - depth, 0.9 * measured, 1.1 * measured);
    const double mean = 0.5 * (near.level + far.level) - depth;
    report.judge({run + ": celerity of the crest between 1.2 and 2.2 m",
                  "m/s",
                  {},
                  std::sqrt(gravity * (depth + mean)),
                  "of a solitary wave of the mean height of our crest"},
                 1 / (far.time - near.time), Relative{0.03});
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
    const Fall fall = follow(setting, report, "wedge", "wedge", trial, records);
    report.judge({"2 s/t^2 at 0.2 s", "m/s^2", {}, {}, "added mass between none and 1.0"},
                 fall.acceleration(0.2, angle), with_added(1), with_added(0));
    report.judge(
        {"vertical speed after 0.44 m", "m/s", 0.6, {}, "the limit that it tends to in the experiment, on rollers"},
        fall.speed_at(0.44), 0.9 * 0.6, 1.1 * 0.6);
}

void scott_russell(const CaseSetting& setting, CaseReport& report) {
    judge_generator(setting, 0.288, 0.10, report);
    judge_generator(setting, 0.21, 0.11, report);
    judge_generator(setting, 0.116, 0.08, report);
}

}  // namespace riprap::validation::mikola
