// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/settle.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double tilt_stiffness = 1e9;  // k_n of the block that tips [Pa]
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

namespace {

struct Failure {
    double angle{std::nan("")};  ///< of the slope when the block begins to go [deg]
    bool is_toppling{false};
};

/// Turns gravity slowly until the block has slid by a thousandth of its width or turned by 0.01, and tells how.
Failure tilt(double width, double height, double friction, double from, double to) {
    SceneBuilder scene;
    scene.add_material({.name = "rock", .density = 2500, .normal_stiffness = tilt_stiffness, .friction = friction});
    BodySpec ground;
    ground.name = "ground";
    ground.shape = scene.add_half_space({0, 0, 1}, 0);
    ground.drive = body::Drive::fixed;
    scene.add_body(ground);
    BodySpec block;
    block.name = "block";
    block.shape = scene.add_shape(geometry::box({width, 1, height}));
    block.pose.position.z = 0.5 * height;
    const BodyId body = scene.add_body(block);
    scene.model.gravity.value = tilted(from);
    Trial trial(std::move(scene));
    trial.follow_energy(false);
    // Close to tipping the block rocks a hundred times slower than its contact swings: local damping takes the same
    // share of every mode, where mass damping would stop the slow ones from settling at all.
    trial.model().solid.local_damping = 0.5;
    trial.run_until(1);
    sim::Gravity& gravity_of = trial.model().gravity;
    gravity_of.axis = {0, -1, 0};  // turns (0, 0, -g) towards +x
    gravity_of.rate = 0.1 * degree;
    gravity_of.start = trial.time();
    const Vec3 x0 = trial.position(body);
    Failure failure;
    const double end = trial.time() + (to - from) / gravity_of.rate;
    while (trial.time() < end && std::isnan(failure.angle)) {
        trial.step();
        const double turn = norm(to_rotation_vector(trial.orientation(body)));
        const double slip = trial.position(body).x - x0.x;
        if (turn > 0.01 || slip > 1e-3 * width) {
            failure.angle = (from + gravity_of.rate * (trial.time() - gravity_of.start)) / degree;
            failure.is_toppling = turn * 0.5 * height > 0.5 * slip;
        }
    }
    return failure;
}

}  // namespace

namespace {

/// Slope at which a block on an elastic base tips [rad]. Near tipping the weight rests on a strip of width 3 x, x from
/// its edge, that sinks in by 2 N/(3 K x); the tilt 2 N/(9 K x^2) moves the weight outwards by h/2 times itself. Rest
/// is possible down to the x where x + h N/(9 K x^2) is least: the weight then passes 1.5 x inside the edge, x^3 = 2 h
/// N/(9 K). K = k_n/r is the stiffness per area of base [N/m^3], the block 1 m long.
double tipping_slope(double width, double height) {
    const double rigid = std::atan(width / height);
    const double load = 2500 * width * height * gravity * std::cos(rigid);
    const double stiffness = tilt_stiffness / (0.5 * std::min({width, height, 1.0}));
    const double inside = 1.5 * std::cbrt(2 * height * load / (9 * stiffness));
    return std::atan((width - 2 * inside) / height);
}

}  // namespace

void tip_or_slide(const CaseSetting&, CaseReport& report) {
    for (const double ratio : {0.2, 0.4, 0.8}) {
        for (const double side : {0.8, 1.25}) {
            const double height = 0.5, width = ratio * height, friction = side * ratio;
            const bool must_topple = side > 1;
            const double exact = (must_topple ? tipping_slope(width, height) : std::atan(friction)) / degree;
            const Failure failure = tilt(width, height, friction, (exact - 1) * degree, (exact + 1) * degree);
            const std::string name =
                fmt::format("b/h = {}, tan phi = {:.3g}: {}", ratio, friction, must_topple ? "topples" : "slides");
            const std::string note =
                must_topple ? fmt::format("on an elastic base; on a rigid one {:.6g}", std::atan(ratio) / degree) : "";
            report.judge({name + " at", "deg", {}, exact, note}, failure.angle, Absolute{0.1});
            report.judge({name + " (1 = topples)", "-", {}, must_topple ? 1.0 : 0.0, {}}, failure.is_toppling ? 1 : 0,
                         Absolute{0});
        }
    }
}

}  // namespace riprap::validation::rigid
