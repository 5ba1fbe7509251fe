// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/settle.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81, degree = M_PI / 180, slope = 30 * degree;

Vec3 tilted(double angle) { return {gravity * std::sin(angle), 0, -gravity * std::cos(angle)}; }

/// A flat block on a half-space, settled. x points down the slope.
Trial block_on_slope(double friction) {
    SceneBuilder scene;
    scene.add_material({.name = "rock", .density = 2500, .normal_stiffness = 1e8, .friction = friction});
    BodySpec ground;
    ground.name = "ground";
    ground.shape = scene.add_half_space({0, 0, 1}, 0);
    ground.drive = body::Drive::fixed;
    scene.add_body(ground);
    BodySpec block;
    block.name = "block";
    block.shape = scene.add_shape(geometry::box({1, 1, 0.1}));
    block.pose.position.z = 0.05;
    scene.add_body(block);
    scene.model.gravity.value = tilted(slope);
    Trial trial(std::move(scene));
    trial.follow_energy(false);
    settle(trial);
    return trial;
}

}  // namespace

void sliding_block(const CaseSetting& setting, CaseReport& report) {
    const BodyId block{1};
    for (const double angle : {0.0, 10.0, 20.0}) {
        Trial trial = block_on_slope(std::tan(angle * degree));
        const double x0 = trial.position(block).x, start = trial.time();
        trial.run_until(start + 2);
        const double t = trial.time() - start;
        const double acceleration = gravity * (std::sin(slope) - std::cos(slope) * std::tan(angle * degree));
        report.judge({fmt::format("slope 30, friction angle {}: 2 s/t^2 at 2 s", angle), "m/s^2", {}, acceleration, {}},
                     2 * (trial.position(block).x - x0) / (t * t), Relative{1e-3});
    }
    for (const double excess : {0.1, -0.1}) {
        Trial trial = block_on_slope(std::tan(slope + excess * degree));
        const double x0 = trial.position(block).x, start = trial.time();
        const double duration = excess < 0 ? 2 : setting.is_full ? 60 : 10;
        trial.run_until(start + duration);
        const double moved = trial.position(block).x - x0;
        if (excess > 0) {
            report.judge_below({fmt::format("friction angle 30.1: creep in {} s", duration), "m", {}, {}, {}}, moved,
                               1e-6);
        } else {
            const double exact = 0.5 * gravity * duration * duration *
                                 (std::sin(slope) - std::cos(slope) * std::tan(slope + excess * degree));
            report.judge({"friction angle 29.9: slides in 2 s", "m", {}, exact, {}}, moved, Relative{0.02});
        }
    }
    {
        // Friction above the slope angle: a moving block stops.
        const double friction = std::tan(40 * degree), speed = 2;
        Trial trial = block_on_slope(friction);
        trial.state().bodies.velocity[1].x = speed;
        const double x0 = trial.position(block).x;
        trial.run_until(trial.time() + 3);
        const double exact = speed * speed / (2 * gravity * (std::cos(slope) * friction - std::sin(slope)));
        report.judge({"friction angle 40, 2 m/s down the slope: stops after", "m", {}, exact, {}},
                     trial.position(block).x - x0, Relative{2e-3});
    }
}

}  // namespace riprap::validation::rigid
