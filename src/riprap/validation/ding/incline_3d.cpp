// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/validation/block_trial.hpp"
#include "riprap/validation/ding/cases_3d.hpp"

namespace riprap::validation::ding {

namespace {

constexpr double gravity = 9.81, degree = M_PI / 180;

struct Rock {
    double density, youngs_modulus, stiffness;
};
constexpr Rock literal{20, 3e3, 5e4};  ///< as printed, with the density of the arch
constexpr Rock stiff{2500, 3e9, 1e8};

/// A cube of 1 m on a ramp of 20 m, gravity tilted instead of the ramp; everything turned about the ramp's normal.
struct Incline {
    ImplicitTrial trial;
    std::int32_t block;
    Vec3 start, down;
    double slope, friction;
    Curve speed{};  ///< of the second that is looked at

    Incline(const Rock& rock, double slope_deg, double friction_deg, double dt, double turn = 0)
        : slope(slope_deg * degree), friction(std::tan(friction_deg * degree)) {
        const Mat3 turned = to_matrix(from_rotation_vector({0, 0, turn}));
        down = turned * Vec3{1, 0, 0};
        add_material(trial.system, {rock.density, rock.youngs_modulus, 0.25},
                     {rock.stiffness, rock.stiffness, false, friction});
        add_box(trial.system, trial.state.blocks, {24, 4, 1},
                {.position = turned * Vec3{9, 0, -0.5}, .deformation = turned, .is_fixed = true});
        block = add_box(trial.system, trial.state.blocks, {1, 1, 1}, {.position = {0, 0, 0.5}, .deformation = turned});
        trial.settings.max_displacement = 10;
        trial.dt = dt;
        // Settled under the pressing part of gravity, then let go.
        trial.system.gravity = {0, 0, -gravity * std::cos(slope)};
        trial.settle(200, 1e-14);
        trial.system.gravity += gravity * std::sin(slope) * down;
        start = trial.position(block);
    }
    double exact() const { return gravity * (std::sin(slope) - std::cos(slope) * friction); }
    double way() const { return dot(trial.position(block) - start, down); }

    /// Largest error of displacement and speed over a second, each over its exact value at the end. With friction the
    /// second begins 0.2 s after the release, when shear springs and the block's own shear strain have taken the load.
    std::pair<double, double> errors() {
        const double begin = friction > 0 ? 0.2 : 0;
        trial.run_until(begin);
        const double v0 = dot(trial.velocity(block), down), s0 = way();
        double way_error = 0, speed_error = 0;
        while (trial.time < begin + 1 - 1e-9) {
            trial.step();
            const double t = trial.time - begin;
            speed.x.push_back(trial.time);
            speed.y.push_back(dot(trial.velocity(block), down));
            way_error = std::max(way_error, std::abs((way() - s0 - v0 * t) / (0.5 * exact()) - t * t));
            speed_error = std::max(speed_error, std::abs((dot(trial.velocity(block), down) - v0) / exact() - t));
        }
        return {way_error, speed_error};
    }
};

/// Returns the speed.
Curve judge_errors(const std::string& name, const Published& paper, Incline incline, double limit, CaseReport& report) {
    const auto [way, speed] = incline.errors();
    report.judge_below({name + ": largest error of way or speed over its final value", "%", paper, 0, {}},
                       100 * std::max(way, speed), limit);
    return incline.speed;
}

}  // namespace

void incline_3d(const CaseSetting& setting, CaseReport& report) {
    Plot plot;
    plot.title = "A cube on an incline, by slope and friction angle";
    plot.subtitle = "soft rock, steps of 0.01 s";
    plot.x.label = "time [s]";
    plot.y.label = "speed [m/s]";
    const auto add = [&plot](const std::string& label, Curve curve) {
        curve.label = label;
        plot.curves.push_back(std::move(curve));
    };
    const std::array<std::pair<double, double>, 3> published{{{0.1, 1.4}, {0.01, 0.56}, {0.001, 0.018}}};
    for (const auto& [dt, error] : published) {
        judge_errors(fmt::format("A, 30 deg, no friction, step {} s", dt), error, Incline(literal, 30, 0, dt), error,
                     report);
        judge_errors(fmt::format("A, stiff rock, step {} s", dt), {}, Incline(stiff, 30, 0, dt), 0.1, report);
    }
    for (const double friction : {0.0, 10.0, 20.0}) {
        add(fmt::format("30 deg, friction {}", friction),
            judge_errors(fmt::format("B, 30 deg, friction angle {} deg, step 0.01 s", friction), {},
                         Incline(literal, 30, friction, 0.01), 0.5, report));
        judge_errors(fmt::format("B, stiff rock, friction angle {} deg", friction), {},
                     Incline(stiff, 30, friction, 0.01), 0.5, report);
    }
    for (const double slope : {15.0, 30.0, 45.0}) {
        Curve curve = judge_errors(fmt::format("C, {} deg, no friction, step 0.01 s", slope), {},
                                   Incline(literal, slope, 0, 0.01), 0.5, report);
        if (slope != 30) {
            add(fmt::format("{} deg, no friction", slope), std::move(curve));
        }
    }
    write_plot(setting, "incline_3d", plot);
    {
        Incline incline(stiff, 30, 35, 0.01);
        incline.trial.step(100);  // springs take the load
        const double before = incline.way();
        incline.trial.step(100);
        report.judge_below({"friction angle 35 deg on 30 deg: drift in 1 s", "m", {}, 0, {}}, incline.way() - before,
                           1e-6);
    }
    Incline straight(stiff, 30, 10, 0.01), turned(stiff, 30, 10, 0.01, 0.7);
    straight.errors();
    turned.errors();
    report.judge_below({"the scene turned by 0.7 rad: difference of the way", "m", {}, 0, {}},
                       straight.way() - turned.way(), 1e-8);
}

}  // namespace riprap::validation::ding
