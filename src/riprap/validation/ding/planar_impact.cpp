// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/validation/dda/planar_trial.hpp"
#include "riprap/validation/ding/planar_cases.hpp"

namespace riprap::validation::ding {

using geometry::Vec2;

namespace {

struct Fall {
    double fall_error{0};  ///< largest |V - g t| before the impact [m/s]
    double rebound{0};     ///< speed when the contact opens [m/s]
    double overlap{0};     ///< [m]
    double error{0};       ///< L2 error of V over 1.0 to 1.9 s, over 10 m/s [-]
    double free_error{0};  ///< the same from the end of the contact on [-]
    double ledger{0};
    Curve curve;
};

/// A square of 1 m falls 5 m on a base with four fixed points [Ding2021, section 3.3.1].
Fall drop(double stiffness, double dt) {
    PlanarTrial trial({2500, 5e10, 0.25}, {.normal_stiffness = stiffness, .shear_stiffness = stiffness / 2.5});
    trial.settings = solid::planar_dda::settings_for(5, 0.002);
    const std::int32_t base = trial.add_box({-5, -1}, {10, 1});
    for (const Vec2& point : {Vec2{-4, -0.9}, Vec2{-4, -0.1}, Vec2{4, -0.9}, Vec2{4, -0.1}}) {
        trial.builder().fix_point(base, point, 100 * stiffness);
    }
    const std::int32_t block = trial.add_box({-0.5, 5}, {1, 1});
    trial.gravity = {0, -10};
    // the base hangs in its fixed points from the start
    trial.dt = dt;
    Fall fall;
    double square = 0, free_square = 0;
    int count = 0, free_count = 0;
    bool has_hit = false;
    const double radius = 0.5;
    trial.run(1.9, [&] {
        const double v = trial.velocity(block).y, t = trial.time;
        has_hit = has_hit || trial.do_touch(base, block);
        if (!has_hit) {
            fall.fall_error = std::max(fall.fall_error, std::abs(v + 10 * t));
        }
        fall.overlap = std::max(fall.overlap, radius - (trial.center(block).y - trial.center(base).y - 0.5));
        if (has_hit && fall.rebound == 0 && v > 0 && !trial.do_touch(base, block)) {
            fall.rebound = v;
        }
        if (t >= 1) {
            const double exact = 10 - 10 * (t - 1);
            square += (v - exact) * (v - exact);
            ++count;
            if (fall.rebound > 0) {
                free_square += (v - exact) * (v - exact);
                ++free_count;
            }
        }
        fall.curve.x.push_back(t);
        fall.curve.y.push_back(v);
    });
    fall.error = std::sqrt(square / count) / 10;
    fall.free_error = std::sqrt(free_square / std::max(1, free_count)) / 10;
    fall.ledger = trial.ledger_error();
    return fall;
}

/// Largest error of speed and displacement of a block that falls freely for a second, over their values at its end [-].
/// Every step rounds the speed once: n steps miss up to n epsilon.
double error_of_free_fall(double dt) {
    PlanarTrial trial({2500, 5e10, 0.25}, {.normal_stiffness = 1e8, .shear_stiffness = 4e7});
    trial.settings = solid::planar_dda::settings_for(5, 10);
    const std::int32_t block = trial.add_box({-0.5, -0.5}, {1, 1});
    trial.gravity = {0, -10};
    trial.dt = dt;
    double most = 0;
    const int count = static_cast<int>(std::lround(1 / dt));
    for (int step = 1; step <= count; ++step) {
        trial.step();
        const double t = step * dt;
        most = std::max(most, std::abs(trial.velocity(block).y + 10 * t) / 10);
        most = std::max(most, std::abs(trial.center(block).y + 5 * t * t) / 5);
    }
    return most;
}

}  // namespace

void planar_free_fall(const CaseSetting& setting, CaseReport& report) {
    for (const double step : {0.1, 0.01, 0.001}) {
        report.judge_below(
            {fmt::format("free fall, step {} s: largest error of speed or way over its final value", step),
             "-",
             "perfect agreement",
             0.0,
             {}},
            error_of_free_fall(step), 1e-12);
    }
    const double dt = 2e-5;
    Plot plot;
    plot.title = "A block falls 5 m on a base: speed for four contact stiffnesses";
    plot.x.label = "time [s]";
    plot.y.label = "speed upwards [m/s]";
    for (const double k : {1e6, 1e7, 1e8, 1e9}) {
        Fall fall = drop(k, dt);
        const double omega = std::sqrt(2 * k / 2500);
        const std::string name = fmt::format("k = {:.0e} N/m: ", k);
        report.judge_below({name + "largest error of the speed while it falls", "m/s", {}, 0.0, {}}, fall.fall_error,
                           1e-9);
        report.judge({name + "restitution", "-", k == 1e9 ? Published{"fits best"} : Published{},
                      std::exp(-std::numbers::pi * omega * dt / 4), "exp(-pi omega dt/4)"},
                     fall.rebound / 10, Absolute{0.02});
        report.judge({name + "deepest overlap", "m", {}, 10 * std::sqrt(2500 / (2 * k)), {}}, fall.overlap,
                     Relative{0.05});
        report.judge_below(
            {name + "energy that the ledger misses, over its turnover", "-", {}, 0.0, {}, Kind::bookkeeping},
            fall.ledger, 1e-6);
        if (k == 1e9) {
            report.judge({"k = 1e9 N/m: speed of the rebound", "m/s", {}, 10.0, {}}, fall.rebound, 9.7, 10);
            report.judge_below(
                {"k = 1e9 N/m: L2 error of the speed from the end of the contact to 1.9 s", "-", {}, 0.0, {}},
                fall.free_error, 0.03);
            // against a rebound in no time, a spring of pi/omega = 3.5 ms misses sqrt(1.5 pi/(0.9 omega)) by itself
            report.judge({"k = 1e9 N/m: L2 error from 1.0 to 1.9 s, the contact included",
                          "-",
                          {},
                          std::sqrt(1.5 * std::numbers::pi / (0.9 * omega)),
                          "of the time that a spring needs"},
                         fall.error, Relative{0.05});
        }
        fall.curve.label = name;
        plot.curves.push_back(fall.curve);
    }
    Curve theory{"theory", {0, 1, 1, 1.9}, {0, -10, 10, 1}, CurveStyle::dashed, -1};
    plot.curves.push_back(theory);
    write_plot(setting, "planar_free_fall", plot);
}

}  // namespace riprap::validation::ding
