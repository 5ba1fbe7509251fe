// SPDX-License-Identifier: Apache-2.0
// Regular waves on a smooth slope: how high they run up [Hunt1959] and how much of them comes back [Seelig1983].
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"
#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/wave_analysis.hpp"

namespace riprap::validation::water {

namespace {

constexpr double depth = 0.4, period = 1.6, toe = 3.5, gravity = 9.81;  ///< of case.toml [m], [s], [m], [m/s^2]
constexpr int periods = 3;                                              ///< at the end, that are looked at
constexpr std::array<double, 3> places{1.3, 1.7, 2.3};                  ///< of the level gauges [m]

/// Beginning of the line of the run-up gauge: a spacing above the slope and 0.2 m above the bed, both [m].
struct GaugeLine {
    double x, y, along_x, along_y;  ///< along: unit vector up the slope
};

GaugeLine line_above(double slope, double spacing) {
    const double cosine = 1 / std::hypot(1, slope), sine = slope * cosine;
    constexpr double start = 0.2;
    return {toe + start / slope - spacing * sine, start + spacing * cosine, cosine, sine};
}

/// The slope, the domain and the gauge above it, as overrides of the case.
std::vector<std::string> setting_of(double slope, double spacing) {
    constexpr double top = 1.2, above = 0.8;  // of the slope, and of the line over its start [m]
    const GaugeLine line = line_above(slope, spacing);
    const double length = above / line.along_y, end = toe + top / slope;
    return {fmt::format("fluid.spacing={}", spacing), fmt::format("fluid.domain.high=[{}, 1.4]", end),
            fmt::format("body.slope.shape.polygon=[[{0}, 0], [{1}, 0], [{1}, {2}]]", toe, end, top),
            fmt::format("output.gauge.run_up.point=[{}, {}]", line.x, line.y),
            fmt::format("output.gauge.run_up.end=[{}, {}]", line.x + length * line.along_x,
                        line.y + length * line.along_y)};
}

wave::Separation separate(const WaterTrial& trial) {
    constexpr double omega = 2 * std::numbers::pi / period;
    const std::span<const double> time = trial.time();
    const auto first = std::lower_bound(time.begin(), time.end(), time.back() - periods * period) - time.begin();
    std::array<std::complex<double>, places.size()> amplitude;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::span<const double> level = trial.column(fmt::format("wave_{}", k + 1));
        const auto from = static_cast<std::size_t>(first);
        amplitude[k] = wave::harmonic(time.subspan(from), level.subspan(from), omega);
    }
    return wave::separate_reflection(places, amplitude, wave::wave_number(omega, depth, gravity));
}

/// Mean over the periods of the highest that water reaches on the slope, above still water [m].
double run_up(const WaterTrial& trial, double slope, double spacing) {
    const GaugeLine line = line_above(slope, spacing);
    const std::vector<double>& reach = trial.column("run_up");
    std::array<double, periods> highest{};
    for (std::size_t i = 0; i < reach.size(); ++i) {
        const double back = (trial.time().back() - trial.time()[i]) / period;
        if (back < periods) {
            double& most = highest[static_cast<std::size_t>(back)];
            most = std::max(most, reach[i]);
        }
    }
    double mean = 0;
    for (const double most : highest) {
        mean += most / periods;
    }
    return line.y - spacing * line.along_x + mean * line.along_y - depth;
}

}  // namespace

void wave_run_up(const CaseSetting& setting, CaseReport& report) {
    const double spacing = setting.is_full ? 0.008 : 0.012;
    for (const int cotangent : {4, 2}) {
        const double slope = 1.0 / cotangent;
        WaterTrial trial(setting, setting_of(slope, spacing));
        trial.run();
        const wave::Separation waves = separate(trial);
        const double height = 2 * waves.incident;
        constexpr double deep_length = gravity * period * period / (2 * std::numbers::pi);
        const double similarity = slope / std::sqrt(height / deep_length);  // xi, Iribarren's number
        const double seelig = similarity * similarity / (5.5 + similarity * similarity);
        const std::string run = fmt::format("1:{}", cotangent);
        report.judge({run + ": incident height", "m", {}, 0.12, "of the wave asked for, linear theory"}, height,
                     Relative{0.03});
        report.judge(
            {run + ": reflected over incident height", "-", seelig, {}, fmt::format("xi = {:.2f}", similarity)},
            waves.reflection, seelig - 0.1, seelig + 0.1);
        const double found = run_up(trial, slope, spacing) / height;
        constexpr double breaking = 2.3;  // xi up to which Hunt's law holds
        const std::string run_up_of = run + ": run-up over incident height";
        if (similarity < breaking) {
            report.judge({run_up_of, "-", similarity, {}, "Hunt"}, found, 0.85 * similarity, 1.15 * similarity);
        } else {
            report.state({run_up_of, "-", fmt::format("Hunt's law ends at xi = {}", breaking)}, found);
        }
        judge_ledger(report, trial, run);
    }
}

}  // namespace riprap::validation::water
