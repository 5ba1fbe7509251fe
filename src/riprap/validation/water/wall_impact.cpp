// SPDX-License-Identifier: Apache-2.0
// Pressure of a dam break on the far wall against the scatter of a hundred repeats [Lobovsky2014] and against another
// simulation of water alone [DeCourcy2024].
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

/// 15 mm above the floor: t sqrt(g/H); 2.5th percentile, median and 97.5th of p/(rho g H), read off the published
/// curves.
constexpr std::array<std::array<double, 4>, 39> percentiles{{
    {2.40, -0.004, 0.001, 0.005}, {2.44, -0.004, 0.001, 0.453}, {2.46, -0.027, 0.055, 1.371},
    {2.48, -0.015, 1.230, 1.774}, {2.50, 1.091, 1.552, 1.815},  {2.52, 1.417, 1.679, 1.967},
    {2.54, 1.601, 1.755, 1.900},  {2.56, 1.678, 1.823, 1.983},  {2.58, 1.719, 1.856, 2.013},
    {2.60, 1.750, 1.858, 1.983},  {2.62, 1.723, 1.840, 1.981},  {2.65, 1.627, 1.756, 1.888},
    {2.70, 1.481, 1.608, 1.746},  {2.75, 1.369, 1.490, 1.617},  {2.80, 1.244, 1.379, 1.530},
    {2.90, 0.911, 1.105, 1.236},  {3.00, 0.781, 0.920, 1.046},  {3.10, 0.658, 0.801, 0.902},
    {3.20, 0.608, 0.718, 0.822},  {3.40, 0.540, 0.627, 0.745},  {3.60, 0.511, 0.604, 0.705},
    {3.80, 0.519, 0.598, 0.694},  {4.00, 0.491, 0.592, 0.712},  {4.20, 0.482, 0.591, 0.711},
    {4.40, 0.487, 0.586, 0.708},  {4.60, 0.476, 0.583, 0.699},  {4.80, 0.442, 0.586, 0.706},
    {5.00, 0.435, 0.581, 0.704},  {5.20, 0.464, 0.584, 0.699},  {5.40, 0.452, 0.583, 0.697},
    {5.60, 0.479, 0.601, 0.711},  {5.80, 0.565, 0.681, 0.852},  {6.00, 0.711, 0.851, 1.005},
    {6.20, 0.729, 0.861, 0.991},  {6.40, 0.697, 0.843, 0.949},  {6.60, 0.590, 0.730, 0.879},
    {6.80, 0.511, 0.644, 0.820},  {7.00, 0.535, 0.665, 0.823},  {7.10, 0.535, 0.645, 0.801},
}};

/// A gauge and its impulse in the other simulation: integral of p/(rho g H) over t sqrt(g/H) from 2.4 to 6.0, read off
/// the published curves, whose lines are some 2 % thick. That one is incompressible SPH with artificial compressibility
/// in a tank of the same proportions: no air, no gate, no friction either [DeCourcy2024].
struct Simulated {
    const char* gauge;
    const char* height;
    double impulse;
};
constexpr std::array<Simulated, 4> simulated{{{"pressure_3mm", "3 mm", 4.011},
                                              {"pressure_15mm", "15 mm", 3.562},
                                              {"pressure_30mm", "30 mm", 2.933},
                                              {"pressure_80mm", "80 mm", 1.158}}};
/// Pressure on the wall 15 mm above the floor, for the picture: t sqrt(g/H) and means of p/(rho g H) over 0.1.
constexpr std::array<std::array<double, 2>, 19> simulated_curve{{{2.5, 1.651},
                                                                 {2.6, 1.754},
                                                                 {2.7, 1.650},
                                                                 {2.8, 1.494},
                                                                 {2.9, 1.331},
                                                                 {3.0, 1.210},
                                                                 {3.2, 1.090},
                                                                 {3.4, 1.040},
                                                                 {3.6, 1.001},
                                                                 {3.8, 0.983},
                                                                 {4.0, 0.959},
                                                                 {4.5, 0.878},
                                                                 {5.0, 0.817},
                                                                 {5.5, 0.752},
                                                                 {5.9, 0.737},
                                                                 {6.2, 0.789},
                                                                 {6.5, 1.151},
                                                                 {6.8, 1.127},
                                                                 {7.0, 1.072}}};

std::vector<double> measured(std::size_t column) {
    std::vector<double> values;
    for (const auto& row : percentiles) {
        values.push_back(row[column]);
    }
    return values;
}

double first_above(std::span<const double> x, std::span<const double> y, double level) {
    const std::vector<double> found = crossings(x, y, level);
    return found.empty() ? std::nan("") : found.front();
}

}  // namespace

void wall_impact(const CaseSetting& setting, CaseReport& report) {
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.0025"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    const double depth = 0.3, unit = std::sqrt(depth / 9.81), pressure_unit = 997 * 9.81 * depth;
    std::vector<double> time;
    for (const double t : trial.time()) {
        time.push_back(t / unit);
    }
    const auto pressure_of = [&](const char* gauge) {
        std::vector<double> out;
        for (const double p : trial.column(gauge)) {
            out.push_back(p / pressure_unit);
        }
        return out;
    };
    const std::vector<double> pressure = running_mean(
        time, pressure_of("pressure_15mm"), 1e-3 / unit);  // as the source asks; rows are a tenth of that apart
    const std::vector<double> t = measured(0), low = measured(1), median = measured(2), high = measured(3);

    // Half the hydrostatic pressure of the column marks the arrival on every curve.
    const double arrival = first_above(t, median, 0.5);
    report.judge({"arrival, t sqrt(g/H)", "-", arrival, {}, "median of the experiments; no gate in the simulation"},
                 first_above(time, pressure, 0.5), arrival - 0.05, arrival + 0.05);
    double peak = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        peak = time[i] < 4 ? std::max(peak, pressure[i]) : peak;
    }
    report.judge({"peak of the impact, p/(rho g H)", "-", *std::max_element(median.begin(), median.end()), {}, {}},
                 peak, *std::max_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end()));
    const double impulse = integral(t, median, 2.4, 4.0);
    report.judge({"impulse from 2.4 to 4.0", "-", impulse, {}, "measured; the other simulation below has 1.92"},
                 integral(time, pressure, 2.4, 4.0), 0.9 * impulse, 1.1 * impulse);
    for (const Simulated& other : simulated) {
        report.judge({fmt::format("impulse at {} from 2.4 to 6.0", other.height),
                      "-",
                      other.impulse,
                      {},
                      "simulation of De Courcy and others 2024: water alone, incompressible"},
                     integral(time, pressure_of(other.gauge), 2.4, 6.0), 0.95 * other.impulse, 1.05 * other.impulse);
    }
    double inside = 0, all = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] >= 2.4 && time[i] <= 7.1) {
            all += 1;
            const bool is_inside =
                pressure[i] >= interpolated(t, low, time[i]) && pressure[i] <= interpolated(t, high, time[i]);
            inside += is_inside ? 1 : 0;
        }
    }
    report.judge({"share of the time from 2.4 to 7.1 inside the 2.5 to 97.5 % band", "-", {}, {}, {}}, inside / all,
                 0.8, 1);
    judge_ledger(report, trial);
    std::vector<double> simulated_time, simulated_pressure;
    for (const auto& [when, mean] : simulated_curve) {
        simulated_time.push_back(when);
        simulated_pressure.push_back(mean);
    }
    write_plot(setting, "wall_impact",
               {"Pressure 15 mm above the floor after a dam break",
                "Lobovsky and others 2014: median and 2.5 to 97.5 % of a hundred repeats",
                {"t sqrt(g/H) [-]", false},
                {"p/(rho g H) [-]", false},
                {{"median", t, median, CurveStyle::line, 0},
                 {"2.5 %", t, low, CurveStyle::dashed, 0},
                 {"97.5 %", t, high, CurveStyle::dashed, 0},
                 {"simulated, De Courcy", simulated_time, simulated_pressure, CurveStyle::markers, 2},
                 {"ours", time, pressure, CurveStyle::line, 1}}});
}

}  // namespace riprap::validation::water
