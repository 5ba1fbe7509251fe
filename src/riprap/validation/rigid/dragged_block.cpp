// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/settle.hpp"

namespace riprap::validation::rigid {

void dragged_block(const CaseSetting&, CaseReport& report) {
    // A plank slides on ice with a block at rest on it: friction mu m g speeds the block up and slows the plank down
    // until both have the speed that momentum gives.
    const double gravity = 9.81, density = 2500, friction = 0.3, speed = 2;
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
    const BodyId lower = scene.add_body(plank);
    BodySpec block;
    block.name = "block";
    block.material = rock;
    block.shape = scene.add_shape(geometry::box({1, 1, 0.1}));
    block.pose.position = {0.8, 0, 0.25};
    const BodyId upper = scene.add_body(block);
    scene.model.gravity.value = {0, 0, -gravity};
    Trial trial(std::move(scene));
    settle(trial, 4000);
    const auto mass = [&trial](BodyId body) { return trial.model().bodies.mass[static_cast<std::size_t>(body.value)]; };
    const double ratio = mass(upper) / mass(lower);
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
}

}  // namespace riprap::validation::rigid
