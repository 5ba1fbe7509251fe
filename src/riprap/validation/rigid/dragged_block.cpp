// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/settle.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81, density = 2500, friction = 0.3;
constexpr BodyId lower{1}, upper{2};

/// A block at rest on a plank on ice.
Trial block_on_plank() {
    SceneBuilder scene;
    const MaterialId ice = scene.add_material({.name = "ice", .density = density, .normal_stiffness = 1e8});
    const MaterialId rock =
        scene.add_material({.name = "rock", .density = density, .normal_stiffness = 1e8, .friction = friction});
    scene.model.materials.pairs[0 * 2 + 1].friction = scene.model.materials.pairs[1 * 2 + 0].friction = 0;
    BodySpec ground;
    ground.name = "ice";
    ground.material = ice;
    ground.shape = scene.add_half_space({0, 0, 1}, 0);
    ground.drive = body::Drive::fixed;
    scene.add_body(ground);
    BodySpec plank;
    plank.name = "plank";
    plank.material = rock;
    plank.shape = scene.add_shape(geometry::box({4, 1, 0.2}));
    plank.pose.position.z = 0.1;
    scene.add_body(plank);
    BodySpec block;
    block.name = "block";
    block.material = rock;
    block.shape = scene.add_shape(geometry::box({1, 1, 0.1}));
    block.pose.position = {0.8, 0, 0.25};
    scene.add_body(block);
    scene.model.gravity.value = {0, 0, -gravity};
    Trial trial(std::move(scene));
    settle(trial, 4000);
    return trial;
}

double mass_of(const Trial& trial, BodyId body) {
    return trial.model().bodies.mass[static_cast<std::size_t>(body.value)];
}

/// The plank is pulled with a steady force, `share` of the one at which the block begins to slip.
void pull_plank(double share, CaseReport& report) {
    Trial trial = block_on_plank();
    const double m = mass_of(trial, upper), M = mass_of(trial, lower), start = trial.time();
    const double force = share * friction * gravity * (m + M);
    const double x_lower = trial.position(lower).x, x_upper = trial.position(upper).x;
    trial.model().loads.push_back({.body = lower, .force = {force, 0, 0}});
    trial.run_until(start + 0.5);
    const double t = trial.time() - start;
    const double above = share <= 1 ? force / (m + M) : friction * gravity;
    const std::string name = fmt::format("plank pulled with {} of the force that parts them, ", share);
    report.judge({name + "acceleration of the block", "m/s^2", {}, above, {}},
                 2 * (trial.position(upper).x - x_upper) / (t * t), Relative{2e-3});
    report.judge({name + "of the plank", "m/s^2", {}, (force - m * above) / M, {}},
                 2 * (trial.position(lower).x - x_lower) / (t * t), Relative{2e-3});
}

}  // namespace

void dragged_block(const CaseSetting&, CaseReport& report) {
    // A plank slides on ice with a block at rest on it: friction mu m g speeds the block up and slows the plank down
    // until both have the speed that momentum gives.
    const double speed = 2;
    Trial trial = block_on_plank();
    const double ratio = mass_of(trial, upper) / mass_of(trial, lower);
    trial.state().bodies.velocity[static_cast<std::size_t>(lower.value)].x += speed;
    const double start = trial.time(), x_lower = trial.position(lower).x, x_upper = trial.position(upper).x;

    const double meet = speed / (friction * gravity * (1 + ratio));
    trial.run_until(start + 0.5 * meet);
    const double t = trial.time() - start;
    report.judge({"acceleration of the block, 2 s/t^2", "m/s^2", {}, friction * gravity, {}},
                 2 * (trial.position(upper).x - x_upper) / (t * t), Relative{2e-3});
    report.judge({"deceleration of the plank", "m/s^2", {}, friction * gravity * ratio, {}},
                 2 * (speed * t - (trial.position(lower).x - x_lower)) / (t * t), Relative{2e-3});
    double meeting = std::nan("");
    trial.run_until(start + 1.5 * meet, [&](const Trial& now) {
        if (std::isnan(meeting) && now.velocity(upper).x >= now.velocity(lower).x) {
            meeting = now.time() - start;
        }
    });
    report.judge({"they move together after", "s", {}, meet, {}}, meeting, Relative{2e-3});
    report.judge({"common speed", "m/s", {}, speed / (1 + ratio), {}},
                 (ratio * trial.velocity(upper).x + trial.velocity(lower).x) / (1 + ratio), Relative{2e-3});
    report.judge_below({"difference of their speeds afterwards", "m/s", {}, {}, {}},
                       trial.velocity(upper).x - trial.velocity(lower).x, 2e-3 * speed);
    for (const double share : {0.9, 1.5}) {
        pull_plank(share, report);
    }
}

}  // namespace riprap::validation::rigid
