// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/submatrices.hpp"
#include "riprap/validation/dda/planar_cases.hpp"
#include "riprap/validation/dda/planar_trial.hpp"

namespace riprap::validation::dda {

namespace {

constexpr double gravity = 9.81;
using geometry::Vec2;

}  // namespace

void planar_rotation(const CaseSetting&, CaseReport& report) {
    PlanarTrial trial({}, {});
    trial.settings = solid::planar_dda::settings_for(10);
    trial.gravity = {};
    trial.dt = 0.01;
    const std::int32_t block = trial.add({{0, 0}, {2, 0}, {1.2, 1.7}, {0.1, 0.9}});
    trial.set_velocity(block, {}, 1);
    const double area = solid::planar_dda::volume_of(trial.model, trial.state, block);
    const double turns = 100, time = turns * 2 * std::numbers::pi;
    trial.run(time);
    const double area_error = solid::planar_dda::volume_of(trial.model, trial.state, block) / area - 1;
    report.judge_below({"100 turns at 0.01 rad a step: relative error of the area",
                        "-",
                        {},
                        0.0,
                        "first-order DDA grows it by the factor e^6.3"},
                       area_error, 1e-10);
    report.judge_below({"error of the angle", "rad", {}, 0.0, {}}, trial.angle(block) - trial.time, 1e-9);
    report.judge_below({"change of the spin", "rad/s", {}, 0.0, {}}, trial.spin(block) - 1, 1e-10);
    double shape = 0;
    for (const double stretch :
         {trial.state.stretch_xx[0] - 1, trial.state.stretch_yy[0] - 1, trial.state.stretch_xy[0]}) {
        shape = std::max(shape, std::abs(stretch));
    }
    report.judge_below({"largest stretch", "-", {}, 0.0, {}}, shape, 1e-10);
}

void planar_pendulum(const CaseSetting& setting, CaseReport& report) {
    // A square of side 1 m hangs from a corner held by a stiff fixed point and swings by 0.01 rad.
    PlanarTrial trial({2500, 5e9, 0.25}, {});
    trial.settings = solid::planar_dda::settings_for(10);
    const std::int32_t block =
        trial.add({{0, 0}, {std::sqrt(0.5), std::sqrt(0.5)}, {0, std::sqrt(2.0)}, {-std::sqrt(0.5), std::sqrt(0.5)}});
    trial.builder().fix_point(block, {0, std::sqrt(2.0)}, 1e9);
    const double tilt = 0.01;
    trial.gravity = {gravity * std::sin(tilt), -gravity * std::cos(tilt)};
    trial.settle(0.05, 200);
    trial.gravity = {0, -gravity};
    trial.dt = 1e-3;
    std::vector<double> crossings;
    double before = trial.angle(block);
    Curve curve{"angle", {}, {}, CurveStyle::line, -1};
    trial.run(4.2, [&] {
        const double now = trial.angle(block);
        if (before * now < 0) {
            crossings.push_back(trial.time - trial.dt * now / (now - before));
        }
        before = now;
        curve.x.push_back(trial.time);
        curve.y.push_back(now);
    });
    const double exact = 2 * std::numbers::pi * std::sqrt(2 * std::sqrt(2.0) / (3 * gravity));
    report.judge({"square pinned at a corner: period", "s", {}, exact, {}},
                 crossings.size() >= 3 ? crossings[2] - crossings[0] : std::nan(""), Relative{1e-3});
    report.judge_below(
        {"way of the pinned corner from its place", "m", {}, 0.0, "weight over its stiffness is 2.5e-5"},
        norm(place_of(trial.state, block, trial.model.fixed_points[0].local) - trial.model.fixed_points[0].anchor),
        5e-5);
    report.judge_below({"energy that the ledger misses, over its turnover", "-", {}, 0.0, {}, Kind::bookkeeping},
                       trial.ledger_error(), 1e-6);
    Plot plot;
    plot.title = "A square pinned at a corner";
    plot.x.label = "time [s]";
    plot.y.label = "angle [rad]";
    plot.curves = {curve};
    write_plot(setting, "planar_pendulum", plot);
}

namespace {

/// A block of 1 x 0.5 m at rest on a plane that dips; friction is set after it has settled.
struct Incline {
    PlanarTrial trial;
    std::int32_t block;
    Vec2 down;

    Incline(double slope_deg, double friction, double dt)
        : trial({2500, 5e10, 0.25}, {.normal_stiffness = 1e9, .shear_stiffness = 4e8, .friction = 2}) {
        const double slope = slope_deg * std::numbers::pi / 180;
        down = {gravity * std::sin(slope), -gravity * std::cos(slope)};
        trial.settings = solid::planar_dda::settings_for(10, 0.1);
        trial.add_box({-2, -1}, {60, 1}, true);
        block = trial.add_box({0, 0}, {1, 0.5});
        trial.gravity = friction > 0 ? down : Vec2{0, down.y};
        trial.settle(0.05, 400);
        trial.gravity = down;
        trial.dt = dt;
        solid::planar_dda::Joint joint = trial.model.joints[0];
        joint.friction = friction;
        trial.model.set_joint(0, 0, joint);
    }
};

}  // namespace

void planar_incline(const CaseSetting& setting, CaseReport& report) {
    const double degree = std::numbers::pi / 180;
    for (const double dt : {0.1, 0.01, 0.001}) {
        Incline incline(30, 0, dt);
        const double start = incline.trial.center(incline.block).x;
        incline.trial.run(1);
        report.judge({fmt::format("30 degrees, no friction, steps of {} s: way in 1 s", dt),
                      "m",
                      dt == 0.1    ? "1.4 % off"
                      : dt == 0.01 ? "0.56 % off"
                                   : "0.018 % off",
                      0.5 * gravity * 0.5,
                      {}},
                     incline.trial.center(incline.block).x - start, Relative{1e-3});
    }
    for (const double angle : {10.0, 20.0, 29.9}) {
        const double friction = std::tan(angle * degree);
        Incline incline(30, friction, 0.005);
        const double start = incline.trial.center(incline.block).x;
        const double a = gravity * (0.5 - std::cos(30 * degree) * friction);
        incline.trial.run(1);
        const double speed = incline.trial.velocity(incline.block).x;
        incline.trial.run(1);
        if (angle < 25) {
            report.judge({fmt::format("30 degrees, friction angle {}: way in 2 s", angle), "m", {}, 2 * a, {}},
                         incline.trial.center(incline.block).x - start, Relative{1e-3});
        }
        report.judge(
            {fmt::format("30 degrees, friction angle {}: speed gained in the second second", angle), "m/s", {}, a, {}},
            incline.trial.velocity(incline.block).x - speed, Relative{1e-3});
        report.judge_below({fmt::format("friction angle {}: energy that the ledger misses, over its turnover", angle),
                            "-",
                            {},
                            0.0,
                            {},
                            Kind::bookkeeping},
                           incline.trial.ledger_error(), 1e-6);
    }
    {
        Incline incline(30, std::tan(30.1 * degree), 0.01);
        incline.trial.run(1);  // the shear springs share the load anew when friction is lowered
        const double start = incline.trial.center(incline.block).x;
        incline.trial.run(setting.is_full ? 60 : 10);
        report.judge_below({"friction angle 30.1: creep", "m", {}, 0.0, setting.is_full ? "in 60 s" : "in 10 s"},
                           incline.trial.center(incline.block).x - start, 1e-6);
    }
    {
        const double friction = std::tan(40 * degree), speed = 2;
        Incline incline(30, friction, 1e-3);
        const double start = incline.trial.center(incline.block).x;
        incline.trial.set_velocity(incline.block, {speed, 0});
        incline.trial.run(2);
        report.judge({"friction angle 40, pushed at 2 m/s: way until it stops",
                      "m",
                      {},
                      speed * speed / (2 * gravity * (std::cos(30 * degree) * friction - 0.5)),
                      {}},
                     incline.trial.center(incline.block).x - start, Relative{2e-3});
    }
}

}  // namespace riprap::validation::dda
