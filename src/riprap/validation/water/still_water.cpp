// SPDX-License-Identifier: Apache-2.0
// Water that should not move, and what it carries.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double gravity = 9.81, rest_density = 1000;

/// rms over particles of p - rho_0 g (level - y), over rho_0 g level [-].
double pressure_error(const WaterTrial& trial, double level) {
    const fluid::ParticleState& water = trial.state().fluid;
    double sum = 0;
    for (std::size_t i = 0; i < water.position.size(); ++i) {
        const double exact = rest_density * gravity * (level - water.position[i].y);
        const double error = fluid::pressure_of(trial.sph(), water.density[i]) - exact;
        sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(water.position.size())) / (rest_density * gravity * level);
}

}  // namespace

void still_tank(const CaseSetting& setting, CaseReport& report) {
    const double depth = 0.5, length = 1.0;
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.01", "end=10"};
    }
    WaterTrial trial(setting, finer);
    double worst_error = 0, fastest = 0;
    const double settled = 0.5 * trial.model().time.end;
    trial.run([&](const WaterTrial& now) {
        if (now.now() > settled) {
            worst_error = std::max(worst_error, pressure_error(now, water_area(now) / length));
            fastest = std::max(fastest, now.report().max_water_speed);
        }
    });
    const double end = trial.now(), weight = rest_density * depth * length * gravity;
    report.judge({"force on the bottom, mean of the second half", "N/m", {}, weight, "m g"},
                 -trial.mean("bottom.fluid_force.y", settled, end), Relative{5e-3});
    report.judge({"upward force of all walls, likewise", "N/m", {}, weight, "m g"},
                 -trial.mean("bottom.fluid_force.y", settled, end) - trial.mean("left.fluid_force.y", settled, end) -
                     trial.mean("right.fluid_force.y", settled, end),
                 Relative{5e-3});
    report.judge_below({"rms error of pressure over rho g H, worst of the second half", "-", {}, 0.0, {}}, worst_error,
                       0.02);
    report.judge_below({"highest speed over sqrt(g H), second half", "-", {}, 0.0, {}},
                       fastest / std::sqrt(gravity * depth), 1e-2);
    const double before = trial.mean("fluid.kinetic", 0.5 * end, 0.75 * end);
    const double after = trial.mean("fluid.kinetic", 0.75 * end, end);
    report.judge({"kinetic energy of the last quarter over that of the third", "-", {}, {}, "at most 1: no growth"},
                 after / before, 0, 1);
    write_plot(setting, "still_tank",
               {"A still tank",
                "nothing should move",
                {"time [s]", false},
                {"kinetic energy [J/m]", true},
                {{"ours", trial.time(), trial.column("fluid.kinetic"), CurveStyle::line, -1}}});
}

void submerged_square(const CaseSetting& setting, CaseReport& report) {
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.005"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    const double side = 0.16, end = trial.now(), start = 0.5 * end;
    const double buoyancy = rest_density * gravity * side * side;
    report.judge({"buoyancy, mean of the second half", "N/m", {}, buoyancy, "rho g V"},
                 trial.mean("square.fluid_force.y", start, end), Relative{0.01});
    report.judge_below({"sideways force over buoyancy", "-", {}, 0.0, {}},
                       trial.mean("square.fluid_force.x", start, end) / buoyancy, 0.01);
    report.judge_below({"moment over buoyancy times side", "-", {}, 0.0, {}},
                       trial.mean("square.fluid_torque.z", start, end) / (buoyancy * side), 0.01);
}

void floating_box(const CaseSetting& setting, CaseReport& report) {
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.01"};
    }
    WaterTrial trial(setting, finer);
    // Level and draft share the water: level = (A + b draft)/L and draft = level - y + h/2.
    const double length = 1.0, side = 0.2, width = 0.28;
    std::vector<double> draft;
    trial.run([&](const WaterTrial& now) {
        const double y = now.state().bodies.position[static_cast<std::size_t>(now.model().bodies.size()) - 1].y;
        draft.push_back((water_area(now) / length - y + 0.5 * side) / (1 - width / length));
    });
    // The mean over whole periods between upward crossings of the exact draft.
    const double exact = 0.5 * side;
    std::vector<double> upward;
    const std::vector<double> all = crossings(trial.time(), draft, exact);
    for (std::size_t i = 0; i < all.size(); i += 2) {
        upward.push_back(all[i]);
    }
    const double start = upward.size() > 1 ? upward.front() : 0;
    const double end = upward.size() > 1 ? upward.back() : trial.now();
    report.judge({"draft, mean over whole periods", "m", {}, exact, "rho_s/rho h"},
                 integral(trial.time(), draft, start, end) / (end - start), Relative{0.01});
    report.judge({"water's force over the weight, likewise", "-", {}, 1.0, {}},
                 trial.mean("box.fluid_force.y", start, end) / (500 * width * side * gravity), Relative{0.01});
    report.judge_below({"largest rotation", "rad", {}, 0.0, {}},
                       *std::max_element(trial.column("box.rotation").begin(), trial.column("box.rotation").end()),
                       1 * M_PI / 180);
    const double count = static_cast<double>(upward.size()) - 1;
    report.state({"period of heave", "s", "in a tank less than four boxes wide: no exact value"},
                 count > 0 ? (end - start) / count : std::nan(""));
    write_plot(setting, "floating_box",
               {"A box of half the density of water finds its draft",
                "Archimedes: half of its height",
                {"time [s]", false},
                {"draft [m]", false},
                {{"ours", trial.time(), draft, CurveStyle::line, -1},
                 {"at rest", {0, trial.now()}, {exact, exact}, CurveStyle::dashed, -1}}});
}

void floating_stability(const CaseSetting& setting, CaseReport& report) {
    // Half as heavy as water a box floats upright from width/height = sqrt(6 s(1-s)) = 1.2247 on, s = 1/2.
    for (const double ratio : {1.10, 1.35}) {
        std::vector<std::string> box{fmt::format("body.box.shape={{box=[{:.3f},0.2]}}", 0.2 * ratio)};
        if (setting.is_full) {
            box.emplace_back("fluid.spacing=0.01");
        }
        WaterTrial trial(setting, box);
        trial.run();
        double largest = 0;
        for (const double angle : trial.column("box.rotation_vector.z")) {
            largest = std::max(largest, std::abs(angle * 180 / M_PI + 3));
        }
        const bool tips = ratio < std::sqrt(1.5);
        // Tips: leaves upright for good, that is by far more than it was set off it. Stands: stays nearer than twice
        // that.
        report.judge({fmt::format("width/height {}: largest angle off upright, let go at 3", ratio),
                      "deg",
                      {},
                      {},
                      tips ? "below 1.2247: tips" : "above 1.2247: stands"},
                     largest, tips ? 15 : 0, tips ? 180 : 6);
    }
}

}  // namespace riprap::validation::water
