// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/zhao/cases.hpp"
#include "riprap/validation/zhao/wedge_scene.hpp"

namespace riprap::validation::zhao {

namespace {

constexpr double plunge = 32.36 * M_PI / 180, half_groove = 50 * M_PI / 180;
constexpr double amplitude = 4.905, period = 0.8, gravity = 9.81;  // [m/s^2], [s], [m/s^2]
constexpr int cycles = 3;

/// Newmark's sliding block: s'' = c (A sin(omega t) - a_y), c = cos(phi_a - theta)/cos(phi_a), a_y = g tan(phi_a -
/// theta), from the time t0 at which the shaking overcomes a_y until the velocity is zero again.
struct Newmark {
    double omega, yield, factor, start;
    double velocity(double t) const {
        return factor * (amplitude / omega * (std::cos(omega * start) - std::cos(omega * t)) - yield * (t - start));
    }
    double slip(double t) const {
        const double w = omega;
        return factor * (amplitude / w * std::cos(w * start) * (t - start) -
                         amplitude / (w * w) * (std::sin(w * t) - std::sin(w * start)) -
                         0.5 * yield * (t - start) * (t - start));
    }
    double peak() const { return 0.5 * period - start; }  ///< where the shaking falls below a_y again [s]
    double stop() const {
        double low = peak(), high = period;
        for (int i = 0; i < 100; ++i) {
            const double middle = 0.5 * (low + high);
            (velocity(middle) > 0 ? low : high) = middle;
        }
        return low;
    }
};

/// The apparent friction angle phi_a follows from the published times: a_y/A = sin(2 pi 0.02/0.8).
Newmark reconstructed() {
    Newmark newmark{};
    newmark.omega = 2 * M_PI / period;
    newmark.start = 0.02;
    newmark.yield = amplitude * std::sin(newmark.omega * newmark.start);
    const double friction_angle = plunge + std::atan(newmark.yield / gravity);
    newmark.factor = std::cos(friction_angle - plunge) / std::cos(friction_angle);
    return newmark;
}

/// One cycle as seen in the record, times from the beginning of the cycle.
struct Cycle {
    double start{std::nan("")}, peak{std::nan("")}, stop{std::nan("")};
    double top_speed{0}, slip{0}, rest_slip{0};
};

/// sqrt(v) grows linearly at first: its zero from two points of the record. A threshold would come late.
double extrapolated_start(double t1, double v1, double t2, double v2) {
    return (t1 * std::sqrt(v2) - t2 * std::sqrt(v1)) / (std::sqrt(v2) - std::sqrt(v1));
}

struct Record {
    std::vector<double> time, slip, speed;
};

Cycle read_cycle(const Record& record, double begin, double reference_speed) {
    Cycle cycle;
    double t1 = 0, v1 = 0, slip_at_begin = std::nan(""), slip_at_rest = std::nan("");
    for (std::size_t i = 0; i < record.time.size(); ++i) {
        const double t = record.time[i] - begin, v = record.speed[i];
        if (t < 0 || t >= period) {
            continue;
        }
        slip_at_begin = std::isnan(slip_at_begin) ? record.slip[i] : slip_at_begin;
        if (v1 == 0 && v > 0.0025 * reference_speed) {
            t1 = t;
            v1 = v;
        }
        if (std::isnan(cycle.start) && v > 0.01 * reference_speed) {
            cycle.start = extrapolated_start(t1, v1, t, v);
        }
        if (v > cycle.top_speed) {
            cycle.top_speed = v;
            cycle.peak = t;
        }
        if (cycle.top_speed > 0.5 * reference_speed && std::isnan(cycle.stop) && v < 0.002 * reference_speed) {
            cycle.stop = t;
        }
        if (t > 0.65) {  // at rest since 0.63 s
            slip_at_rest = std::isnan(slip_at_rest) ? record.slip[i] : slip_at_rest;
            cycle.rest_slip = std::max(cycle.rest_slip, std::abs(record.slip[i] - slip_at_rest));
        }
        cycle.slip = record.slip[i] - slip_at_begin;
    }
    return cycle;
}

Record shake() {
    const Newmark theory = reconstructed();
    const double apparent = std::tan(plunge + std::atan(theory.yield / gravity));
    WedgeTrial wedge({.plunge = plunge,
                      .left_angle = half_groove,
                      .right_angle = half_groove,
                      .density = 2000,
                      .stiffness = 2e8,
                      .shear_ratio = 10,
                      .friction = apparent * std::sin(half_groove),
                      .shake = amplitude,
                      .period = period});
    Record record;
    wedge.trial.run_until(wedge.start + cycles * period, [&](const Trial& now) {
        record.time.push_back(now.time() - wedge.start);
        record.slip.push_back(dot(wedge.displacement(), wedge.theory.along));
        record.speed.push_back(dot(wedge.velocity(), wedge.theory.along));
    });
    return record;
}

void plot_record(const CaseSetting& setting, const Record& record, const Newmark& theory) {
    Plot speed, slip;
    speed.title = "Wedge on a shaken slope: velocity relative to the slope";
    slip.title = "Wedge on a shaken slope: slip";
    speed.subtitle = slip.subtitle = "ground acceleration 0.5 g sin(2 pi t/0.8 s); theory: Newmark's sliding block";
    speed.x.label = slip.x.label = "time [s]";
    speed.y.label = "velocity [m/s]";
    slip.y.label = "slip [m]";
    std::vector<double> exact_speed, exact_slip;
    const double per_cycle = theory.slip(theory.stop());
    for (const double time : record.time) {
        const double cycle = std::floor(time / period), t = time - cycle * period;
        const double moving = std::clamp(t, theory.start, theory.stop());
        exact_speed.push_back(theory.velocity(moving));
        exact_slip.push_back(cycle * per_cycle + theory.slip(moving));
    }
    speed.curves = {{"theory", record.time, exact_speed, CurveStyle::line, 0},
                    {"ours", record.time, record.speed, CurveStyle::markers, 1}};
    slip.curves = {{"theory", record.time, exact_slip, CurveStyle::line, 0},
                   {"ours", record.time, record.slip, CurveStyle::markers, 1}};
    write_plot(setting, "wedge_dynamic_velocity", speed);
    write_plot(setting, "wedge_dynamic_slip", slip);
}

}  // namespace

void wedge_dynamic(const CaseSetting& setting, CaseReport& report) {
    const Newmark theory = reconstructed();
    const Record record = shake();
    const double top = theory.velocity(theory.peak()), slip = theory.slip(theory.stop());
    for (int i = 0; i < cycles; ++i) {
        const Cycle cycle = read_cycle(record, i * period, top);
        const auto of = [i](const char* what) { return fmt::format("cycle {}, {}", i + 1, what); };
        report.judge({of("starts"), "s", 0.02, theory.start, {}}, cycle.start, Absolute{2e-3});
        report.judge({of("fastest"), "s", 0.38, theory.peak(), {}}, cycle.peak, Absolute{2e-3});
        report.judge({of("stops"), "s", 0.629, theory.stop(), {}}, cycle.stop, Absolute{3e-3});
        report.judge({of("top speed"), "m/s", {}, top, "amplitude not in the paper: 0.5 g"}, cycle.top_speed,
                     Relative{0.01});
        report.judge({of("slip"), "m", {}, slip, {}}, cycle.slip, Relative{0.01});
        report.judge_below({of("slip while at rest"), "m", std::string("rests to 0.8 s"), {}, {}}, cycle.rest_slip,
                           1e-5);
    }
    plot_record(setting, record, theory);
}

}  // namespace riprap::validation::zhao
