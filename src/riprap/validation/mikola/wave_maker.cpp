// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/mikola/cases.hpp"
#include "riprap/validation/mikola/water_run.hpp"
#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/wave_analysis.hpp"

namespace riprap::validation::mikola {

namespace {

constexpr double gravity = 9.81, depth = 2, period = 4, height = 0.4, ramp = period;  ///< of case.toml
constexpr double slope = 0.04;                                                        ///< of the beach [-]
constexpr double beach_length = depth / slope, omega = 2 * M_PI / period;

/// Length of the flume. The short one lasts until steady waves passed its last gauge for two periods.
struct Flume {
    double toe, end, spacing;     ///< [m], [s], [m]
    std::array<double, 3> gauge;  ///< [m]
};
constexpr Flume full_flume{70, 48, 0.054, {20, 40, 60}}, short_flume{20, 18, 0.1, {5, 10, 15}};

Trial flume_trial(const CaseSetting& setting, const Flume& flume) {
    constexpr std::array names{"near", "middle", "far"};
    const double shore = flume.toe + beach_length;
    std::vector<std::string> overrides{fmt::format("end={}", flume.end), fmt::format("fluid.spacing={}", flume.spacing),
                                       fmt::format("fluid.domain.high=[{},3.5]", shore + 15),
                                       fmt::format("fluid.region.0.box.high=[{},{}]", shore + 10, depth),
                                       fmt::format("body.beach.position=[{},0]", flume.toe)};
    for (std::size_t i = 0; i < names.size(); ++i) {
        overrides.push_back(fmt::format("output.gauge.surface_{}.point=[{},0]", names[i], flume.gauge[i]));
        overrides.push_back(fmt::format("output.gauge.surface_{}.end=[{},3.4]", names[i], flume.gauge[i]));
    }
    // One spacing above the beach, from half the depth to 0.6 m above still water.
    const double x = flume.toe + 0.5 * beach_length, y = 0.5 * depth + flume.spacing;
    overrides.push_back(fmt::format("output.gauge.run_up.point=[{},{}]", x, y));
    overrides.push_back(fmt::format("output.gauge.run_up.end=[{},{}]", x + 40, y + 40 * slope));
    return trial_of(setting, overrides);
}

/// A stretch of one gauge's record.
struct Stretch {
    std::vector<double> time, level;
    Stretch(const WaterRecords& records, std::size_t gauge, double from, double to) {
        for (std::size_t i = 0; i < records.time.size(); ++i) {
            if (records.time[i] >= from && records.time[i] <= to) {
                time.push_back(records.time[i]);
                level.push_back(records.gauge[gauge][i]);
            }
        }
    }
};

double mean_height(const Stretch& stretch) {
    const auto waves = wave::zero_crossing_waves(stretch.time, stretch.level);
    double sum = 0;
    for (const wave::ZeroCrossingWave& wave : waves) {
        sum += wave.height;
    }
    return sum / static_cast<double>(waves.size());  // NaN where there is none
}

/// When the envelope, the amplitude of one frequency over a period, first reaches `level` [s].
double time_of_envelope(const WaterRecords& records, std::size_t gauge, double level, double end) {
    const double step = 0.05;
    double before = 0;
    for (double t = 0.5 * period; t < end - 0.5 * period; t += step) {
        const Stretch stretch(records, gauge, t - 0.5 * period, t + 0.5 * period);
        const double now = std::abs(wave::harmonic(stretch.time, stretch.level, omega));
        if (now >= level) {
            return t - step * (now - level) / std::max(now - before, 1e-12);
        }
        before = now;
    }
    return std::nan("");
}

/// Celerity from the phases of two gauges; theory only counts whole waves between them.
double celerity_between(const Stretch& near, const Stretch& far, double distance, double wave_number) {
    const double turn =
        std::arg(wave::harmonic(far.time, far.level, omega) / wave::harmonic(near.time, near.level, omega));
    const double whole = std::round((wave_number * distance - turn) / (2 * M_PI));
    return omega * distance / (turn + 2 * M_PI * whole);
}

void judge_waves(const Flume& flume, const WaterRecords& records, CaseReport& report) {
    const wave::LinearWave theory = wave::linear_wave(height, period, depth, gravity);
    // Steady once the whole stroke has travelled to the last gauge.
    const double steady = ramp + flume.gauge[2] / theory.group_velocity();
    std::vector<Stretch> stretches;
    std::vector<double> heights;
    for (std::size_t g = 0; g < flume.gauge.size(); ++g) {
        stretches.emplace_back(records, g, steady, flume.end);
        heights.push_back(mean_height(stretches.back()));
        report.judge({fmt::format("wave height at x = {} m", flume.gauge[g]), "m", {}, height, {}}, heights.back(),
                     Relative{0.08});
    }
    const double distance = flume.gauge[2] - flume.gauge[0];
    report.judge({"celerity", "m/s", {}, theory.celerity(), {}},
                 celerity_between(stretches[0], stretches[2], distance, theory.wave_number), Relative{0.02});
    const double arrival =
        time_of_envelope(records, 2, 0.25 * height, flume.end) - time_of_envelope(records, 0, 0.25 * height, flume.end);
    report.judge({fmt::format("time of half the wave height over {} m", distance),
                  "s",
                  {},
                  distance / theory.group_velocity(),
                  {}},
                 arrival, Relative{0.05});
    const double s = std::sinh(theory.kd()), c = std::cosh(theory.kd());
    const double bound = height * height * theory.wave_number / 16 * c * (2 + std::cosh(2 * theory.kd())) / (s * s * s);
    report.state(
        {"second harmonic at the middle gauge", "m",
         fmt::format("Stokes' bound harmonic is {:.3g} m; the sine of the piston adds a free one of unknown phase",
                     bound)},
        std::abs(wave::harmonic(stretches[1].time, stretches[1].level, 2 * omega)));
    if (flume.toe == full_flume.toe) {
        report.judge({"loss of height over 40 m", "-", {}, {}, {}}, 1 - heights[2] / heights[0], -0.1, 0.1);
        const double along = *std::max_element(records.gauge[3].begin(), records.gauge[3].end());
        const double above = along * std::sin(std::atan(slope)) - 0.5 * depth;
        report.judge({"run-up (Hunt)", "m", {}, 0.13, {}}, above, Relative{0.4});
    }
}

}  // namespace

void wave_maker(const CaseSetting& setting, CaseReport& report) {
    const Flume& flume = setting.is_full ? full_flume : short_flume;
    Trial trial = flume_trial(setting, flume);
    const double mass = trial.model().particles()->filled_volume * trial.model().particles()->settings().rest_density;
    WaterRecords records;
    int inside = 0;
    run_water(trial, records, flume.end, 0.05,
              [&](const Trial& now) { inside = std::max(inside, count_inside_solids(now, 0.5 * flume.spacing)); });
    judge_waves(flume, records, report);
    report.judge({"mass of water at the end", "kg/m", {}, mass, {}, Kind::bookkeeping},
                 trial.report().ledger.fluid.mass, Relative{1e-9});
    report.judge_below(
        {"most particles at a time more than half a spacing inside a solid", "-", {}, {}, {}, Kind::bookkeeping},
        inside, 0);
    judge_ledgers(report, "flume", records);
    Plot plot;
    plot.title = "Waves of a piston";
    plot.x.label = "time [s]";
    plot.y.label = "surface above the bed [m]";
    for (std::size_t g = 0; g < flume.gauge.size(); ++g) {
        plot.curves.push_back(
            {fmt::format("x = {} m", flume.gauge[g]), records.time, records.gauge[g], CurveStyle::line, -1});
    }
    write_plot(setting, "wave_maker_surface", plot);
    write_plot(setting, "wave_maker_end", water_view(trial, "Flume at the end"));
}

}  // namespace riprap::validation::mikola
