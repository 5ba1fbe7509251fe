// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/mikola/cases.hpp"
#include "riprap/validation/mikola/water_run.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::mikola {

namespace {

constexpr double gravity = 9.81, angle = 25 * M_PI / 180, density = 2500, water = 1000;
constexpr double depth = 1, wedge_height = 0.5, channel = 12;  ///< [m]
constexpr double coarse = 0.04;                                ///< spacing of the short version [m]

using Overrides = std::vector<std::string>;

/// The case with other friction and its wedge's tip `above` the water line [m].
Trial wedge_trial(const CaseSetting& setting, double friction, double above, const Overrides& more = {}) {
    Overrides overrides{fmt::format("material.rock.friction_coefficient={}", friction),
                        fmt::format("body.wedge.position=[{:.17g},{:.17g}]", -above / std::tan(angle), depth + above)};
    if (!setting.is_full) {
        overrides.push_back(fmt::format("fluid.spacing={}", coarse));
    }
    overrides.insert(overrides.end(), more.begin(), more.end());
    return trial_of(setting, overrides);
}

double way(const Trial& trial, const Vec3& start) {
    return dot(trial.position(trial.body("wedge")) - start, Vec3{std::cos(angle), -std::sin(angle), 0});
}

/// 2 s/t^2 of a wedge that starts from rest [m/s^2].
double acceleration_over(Trial& trial, double time, WaterRecords& records) {
    const Vec3 start = trial.position(trial.body("wedge"));
    run_water(trial, records, time, 0.01);
    return 2 * way(trial, start) / (trial.time() * trial.time());
}

void judge_dry(const CaseSetting& setting, CaseReport& report) {
    for (const double friction : {0.0, 0.2}) {
        // A puddle at the foot of the slope: the wedge stays out of it.
        Trial trial = wedge_trial(setting, friction, 0.5, {"fluid.region.0.level=0.2", "fluid.spacing=0.05"});
        WaterRecords records;
        const double exact = gravity * (std::sin(angle) - friction * std::cos(angle));
        report.judge({fmt::format("dry, mu = {}: 2 s/t^2 at 0.4 s", friction), "m/s^2", {}, exact, {}},
                     acceleration_over(trial, 0.4, records), Relative{1e-3});
    }
}

/// Acceleration of a submerged wedge that carries `added` times the mass of its water along [m/s^2].
double submerged_acceleration(double added) {
    return (density - water) / (density + added * water) * gravity * std::sin(angle);
}

/// Way of a submerged wedge from rest: (m + C_m m_w) s'' = (m - m_w) g sin(angle) - C_d rho_w A s'^2/2, where m_w is
/// the mass of its water and A its section across the slope [m].
double submerged_way(double time, double added, double drag) {
    const double volume = 0.5 * wedge_height * wedge_height / std::tan(angle), section = wedge_height * std::cos(angle);
    const double inertia = (density + added * water) * volume;
    const double force = (density - water) * volume * gravity * std::sin(angle), half = 0.5 * drag * water * section;
    if (half == 0) {
        return 0.5 * force / inertia * time * time;
    }
    const double fastest = std::sqrt(force / half);  // s' = v tanh(t/T), T = inertia v/force
    return inertia / half * std::log(std::cosh(time * force / (inertia * fastest)));
}

void judge_submerged(const CaseSetting& setting, CaseReport& report) {
    Trial trial = wedge_trial(setting, 0, -0.6);  // top 0.1 m below the surface
    const double mass = density * 0.5 * wedge_height * wedge_height / std::tan(angle);
    report.judge({"mass of the wedge", "kg/m", mass, {}, "2500 kg/m^3", Kind::bookkeeping},
                 trial.model().bodies.mass[static_cast<std::size_t>(trial.body("wedge").value)], 0.99 * mass,
                 1.01 * mass);
    WaterRecords records;
    const Vec3 start = trial.position(trial.body("wedge"));
    const double value = acceleration_over(trial, 0.2, records);
    report.judge({"submerged by 0.1 m, mu = 0: 2 s/t^2 at 0.2 s", "m/s^2", {}, {}, "added mass between none and 1.0"},
                 value, submerged_acceleration(1), submerged_acceleration(0));
    run_water(trial, records, 0.5, 0.01);
    report.judge({"submerged by 0.1 m, mu = 0: way at 0.5 s",
                  "m",
                  {},
                  {},
                  "drag equation: C_m 1 and C_d 2 of a plate held across the flow, to C_m 0.5 without drag"},
                 way(trial, start), submerged_way(trial.time(), 1, 2), submerged_way(trial.time(), 0.5, 0));
}

/// Volume between surface and walls, from columns 0.05 m apart [m^2].
double volume_under_surface(const Trial& trial) {
    const double step = 0.05, foot = depth / std::tan(angle);
    double volume = 0;
    for (int i = 0; (i + 0.5) * step < channel + 2; ++i) {
        const double x = channel - (i + 0.5) * step;
        const double bed = std::max(0.0, depth * (1 - x / foot));
        volume += step * std::max(0.0, surface_at(trial, x, 0, 2.4) - bed);
    }
    return volume;
}

void judge_wave(const WaterRecords& records, CaseReport& report) {
    const water::Crest near = water::crest_of(records.time, records.gauge[0]),
                       far = water::crest_of(records.time, records.gauge[3]);
    const double celerity = 3 / (far.time - near.time), height = 0.5 * (near.level + far.level) - depth;
    report.judge({"mu = 0: celerity of the leading crest between x = 6 and 9 m",
                  "m/s",
                  {},
                  {},
                  fmt::format("crest {:.3f} m; sqrt(g h) to sqrt(g (h + a)), 3 % on either side", height)},
                 celerity, 0.97 * std::sqrt(gravity * depth), 1.03 * std::sqrt(gravity * (depth + height)));
}

void plot_surface(const CaseSetting& setting, const WaterRecords& records) {
    Plot plot;
    plot.title = "Wedge slides into water: surface";
    plot.x.label = "time [s]";
    plot.y.label = "surface above the bed [m]";
    for (std::size_t g = 0; g < records.gauge.size(); ++g) {
        plot.curves.push_back({fmt::format("x = {} m", 6 + g), records.time, records.gauge[g], CurveStyle::line, -1});
    }
    write_plot(setting, "sliding_wedge_surface", plot);
}

/// The slide from the water line on, until its wave nears the end wall, or to the foot of the slope.
void judge_slide(const CaseSetting& setting, CaseReport& report, double friction, double end) {
    Trial trial = wedge_trial(setting, friction, 0);
    const std::string run = fmt::format("mu = {}", friction);
    const double spacing = trial.model().particles()->settings().spacing;
    const double solid = 0.5 * wedge_height * wedge_height / std::tan(angle);
    const double filled = trial.model().particles()->filled_volume;
    WaterRecords records;
    int inside = 0, frame = 0;
    run_water(trial, records, end, 0.01, [&](const Trial& now) {
        inside = std::max(inside, count_inside_solids(now, 0.5 * spacing));
        if (now.time() >= 0.5 * frame) {
            const std::string title = fmt::format("Wedge, {}: {:.2f} s", run, now.time());
            write_plot(setting, fmt::format("sliding_wedge_mu{}_{}", friction, frame++), water_view(now, title));
        }
    });
    report.judge_below({run + ": most particles at a time more than half a spacing inside a solid",
                        "-",
                        {},
                        {},
                        {},
                        Kind::bookkeeping},
                       inside, 0);
    judge_ledgers(report, run, records);
    if (friction > 0) {
        return;
    }
    const double volume = volume_under_surface(trial);
    report.judge({run + ": volume under the surface, of water and wedge, at the end", "m^2", {}, filled + solid, {}},
                 volume, Relative{0.01});
    report.judge({run + ": rise of the level, in volumes of the wedge", "-", {}, 1.0, {}}, (volume - filled) / solid,
                 Relative{0.05});
    judge_wave(records, report);
    plot_surface(setting, records);
}

}  // namespace

void sliding_wedge(const CaseSetting& setting, CaseReport& report) {
    judge_dry(setting, report);
    judge_submerged(setting, report);
    judge_slide(setting, report, 0, 3.6);
    judge_slide(setting, report, 0.2, 1.5);
}

}  // namespace riprap::validation::mikola
