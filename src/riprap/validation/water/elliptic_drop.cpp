// SPDX-License-Identifier: Apache-2.0
// A drop that stretches freely, the free surface without walls or weight [Monaghan1994].
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double rate = 100;  ///< [1/s]

/// Semi-axes of an ellipse of fluid with u = -k x, v = k y and p = 0 on its rim, which stays one:
///
///     da/dt = -k a,    db/dt = k b,    dk/dt = k^2 (a^2 - b^2)/(a^2 + b^2).
///
/// The pressure P (1 - x^2/a^2 - y^2/b^2) with P = rho k^2 a^2 b^2/(a^2 + b^2) makes both momentum equations hold.
struct Ellipse {
    double a{1}, b{1}, k{rate};
};

Ellipse drop_at(double time) {
    constexpr int steps = 4000;
    const double dt = time / steps;
    const auto slope = [](const Ellipse& e) {
        const double a2 = e.a * e.a, b2 = e.b * e.b;
        return Ellipse{-e.k * e.a, e.k * e.b, e.k * e.k * (a2 - b2) / (a2 + b2)};
    };
    const auto along = [](const Ellipse& e, const Ellipse& s, double dt_part) {
        return Ellipse{e.a + dt_part * s.a, e.b + dt_part * s.b, e.k + dt_part * s.k};
    };
    Ellipse e;
    for (int i = 0; i < steps; ++i) {
        e = along(e, slope(along(e, slope(e), 0.5 * dt)), dt);  // midpoint rule
    }
    return e;
}

/// Twice the root of the mean of y^2 (of x^2): the semi-axis of an even ellipse [m].
double semi_axis(const WaterTrial& trial, bool upright) {
    double sum = 0;
    for (const Vec3& x : trial.state().fluid.position) {
        sum += upright ? x.y * x.y : x.x * x.x;
    }
    return 2 * std::sqrt(sum / static_cast<double>(trial.state().fluid.position.size()));
}

}  // namespace

void elliptic_drop(const CaseSetting& setting, CaseReport& report) {
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.0125"};
    }
    WaterTrial trial(setting, finer);
    sim::State& start = trial.initial();
    for (std::size_t i = 0; i < start.fluid.position.size(); ++i) {
        start.fluid.velocity[i] = rate * Vec3{-start.fluid.position[i].x, start.fluid.position[i].y, 0};
    }
    const double radius = semi_axis(trial, true), area = water_area(trial);
    std::vector<double> longer, shorter, exact_longer, exact_shorter;
    trial.run([&](const WaterTrial& now) {
        longer.push_back(semi_axis(now, true) / radius);
        shorter.push_back(semi_axis(now, false) / radius);
        exact_longer.push_back(drop_at(now.now()).b);
        exact_shorter.push_back(drop_at(now.now()).a);
    });
    for (const double time : {0.0038, 0.0076}) {
        const Ellipse exact = drop_at(time);
        report.judge({fmt::format("longer semi-axis at {:.1f} ms over the radius", 1e3 * time), "-", {}, exact.b, {}},
                     interpolated(trial.time(), longer, time), Relative{0.01});
        report.judge({"shorter semi-axis, likewise", "-", {}, exact.a, {}}, interpolated(trial.time(), shorter, time),
                     Relative{0.01});
    }
    report.judge({"area at its density over that at the start", "-", {}, 1.0, {}, Kind::bookkeeping},
                 water_area(trial) / area, Relative{0.01});
    judge_ledger(report, trial);
    write_plot(setting, "elliptic_drop",
               {"A drop that stretches",
                "semi-axes of an ellipse under no force but its own inertia",
                {"time [s]", false},
                {"semi-axis over the radius [-]", false},
                {{"longer, exact", trial.time(), exact_longer, CurveStyle::line, 0},
                 {"longer, ours", trial.time(), longer, CurveStyle::markers, 0},
                 {"shorter, exact", trial.time(), exact_shorter, CurveStyle::line, 1},
                 {"shorter, ours", trial.time(), shorter, CurveStyle::markers, 1}}});
}

}  // namespace riprap::validation::water
