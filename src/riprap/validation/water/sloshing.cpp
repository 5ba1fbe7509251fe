// SPDX-License-Identifier: Apache-2.0
// Water in a tank that pitches slowly: Akyildiz and Unal (2006).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/core/mat3.hpp"
#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

/// Pressure on an end wall, 0.17 m above its foot, from 3 s on: t [s], p [kPa].
constexpr std::array<double, 9> measured_time{3.051, 3.422, 3.794, 4.166, 4.567, 4.925, 5.311, 5.683, 6.055};
constexpr std::array<double, 9> measured_pressure{3.170, 3.378, 3.561, 3.578, 3.370, 3.075, 2.910, 2.823, 3.057};
/// Reading of the dry gauge high on the other wall [kPa]: the zero of these instruments. Still water over the lower
/// gauge is 0.295 m deep, 2.894 kPa, and its record swings about 3.2 kPa.
constexpr double zero_reading = 0.245;

/// Mean and amplitude of p = a + b cos wt + c sin wt, fitted by least squares.
struct Swing {
    double mean, amplitude;
};

Swing swing_of(std::span<const double> t, std::span<const double> p, double w, double start, double end) {
    Mat3 moments;
    Vec3 values;
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (t[i] >= start && t[i] <= end) {
            const Vec3 base{1, std::cos(w * t[i]), std::sin(w * t[i])};
            for (int row = 0; row < 3; ++row) {
                values[row] += base[row] * p[i];
                for (int column = 0; column < 3; ++column) {
                    moments(row, column) += base[row] * base[column];
                }
            }
        }
    }
    const Vec3 fit = inverse(moments) * values;
    return {fit.x, std::hypot(fit.y, fit.z)};
}

}  // namespace

void sloshing(const CaseSetting& setting, CaseReport& report) {
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.00505494505"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    std::vector<double> pressure;  // [kPa], with the zero of the instrument
    for (const double p : trial.column("end_wall")) {
        pressure.push_back(1e-3 * p + zero_reading);
    }
    double sum = 0;
    for (std::size_t i = 0; i < measured_time.size(); ++i) {
        sum += std::pow(interpolated(trial.time(), pressure, measured_time[i]) - measured_pressure[i], 2);
    }
    report.judge_below({"rms difference of the pressure after 3 s", "kPa", {}, 0.0, "zero of the gauges 0.245 kPa"},
                       std::sqrt(sum / static_cast<double>(measured_time.size())), 0.1);
    const double w = 2, start = measured_time.front(), end = measured_time.back();  // [rad/s], [s]
    const Swing theirs = swing_of(measured_time, measured_pressure, w, start, end);
    const Swing ours = swing_of(trial.time(), pressure, w, start, end);
    report.judge({"mean pressure", "kPa", theirs.mean, {}, {}}, ours.mean, 0.97 * theirs.mean, 1.03 * theirs.mean);
    report.judge({"amplitude of the pressure", "kPa", theirs.amplitude, {}, {}}, ours.amplitude,
                 0.97 * theirs.amplitude, 1.03 * theirs.amplitude);
    judge_ledger(report, trial);
    write_plot(setting, "sloshing",
               {"Pressure on an end wall of a pitching tank",
                "Akyildiz and Unal 2006",
                {"time [s]", false},
                {"pressure [kPa]", false},
                {{"measured",
                  {measured_time.begin(), measured_time.end()},
                  {measured_pressure.begin(), measured_pressure.end()},
                  CurveStyle::markers,
                  -1},
                 {"ours", trial.time(), pressure, CurveStyle::line, -1}}});
}

}  // namespace riprap::validation::water
