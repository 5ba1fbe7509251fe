// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/rigid/tipping.hpp"
#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81;

/// A base that starts at rest at `start`, whose acceleration grows steadily to `knee` in `rise`, then at `rate` on.
struct BaseMotion {
    double start, rise, knee, rate, end;  ///< [s], [s], [m/s^2], [m/s^3], [s]

    double acceleration(double time) const {
        const double t = time - start;
        return t < 0 ? 0 : t < rise ? knee * t / rise : knee + rate * (t - rise);
    }
    /// Acceleration linear in time is a cubic stroke, which the spline meets exactly.
    body::PrescribedMotion motion() const {
        const double t = end - start - rise, v = knee * rise / 2, x = knee * rise * rise / 6;
        body::SplineMotion spline;
        spline.time = {0, rise, rise + t};
        spline.stroke = {0, x, x + v * t + knee * t * t / 2 + rate * t * t * t / 6};
        spline.rate = {0, v, v + knee * t + rate * t * t / 2};
        return {.law = std::move(spline), .start = start};
    }
};

struct Failure {
    double acceleration{std::nan("")};  ///< of the base when the block begins to go [m/s^2]
    bool is_toppling{false};
};

/// Contacts are damped, not the motion through space: that would brake the block on its moving base.
Failure shake(const StandingBlock& block, double friction, const BaseMotion& base) {
    SceneBuilder scene;
    scene.add_material({.name = "rock",
                        .density = block.density,
                        .normal_stiffness = block.stiffness,
                        .friction = friction,
                        .damping_ratio = 0.1});
    BodySpec ground;
    ground.name = "ground";
    ground.shape = scene.add_half_space({0, 0, 1}, 0);
    ground.drive = body::Drive::driven;
    ground.motion = base.motion();
    const BodyId floor = scene.add_body(ground);
    BodySpec spec;
    spec.name = "block";
    spec.shape = scene.add_shape(geometry::box({block.width, 1, block.height}));
    const double sunk = block.density * block.height * gravity * 0.5 * block.width / block.stiffness;
    spec.pose.position.z = 0.5 * block.height - sunk;  // N = k_n/r S d
    const BodyId body = scene.add_body(spec);
    scene.model.gravity.value = {0, 0, -gravity};
    Trial trial(std::move(scene));
    trial.follow_energy(false);
    // The base goes forwards, so that the block leans on its rear edge.
    const Vec3 edge{-0.5 * block.width, 0, -0.5 * block.height};
    const double largest_turn = 2 * tipping_tilt(block.foot());
    Failure failure;
    while (trial.time() < base.end && std::isnan(failure.acceleration)) {
        trial.step();
        // Speed, not displacement: springs take the speed of a driven body at the end of each step, so that the block
        // lags behind its base by half a step's displacement without slipping.
        const Vec3 arm = rotate(trial.orientation(body), edge);
        const double slip_rate =
            norm(trial.velocity(body) + cross(trial.angular_velocity(body), arm) - trial.velocity(floor));
        const double turn = norm(to_rotation_vector(trial.orientation(body)));
        if (slip_rate > 5e-3 || turn > largest_turn) {
            failure = {base.acceleration(trial.time()), turn > largest_turn};
        }
    }
    return failure;
}

}  // namespace

void shaken_block(const CaseSetting&, CaseReport& report) {
    const StandingBlock block{0.2, 0.5, 2500, 1e9};
    const double ratio = block.width / block.height;
    for (const double side : {0.8, 1.25}) {
        const double friction = side * ratio;
        const bool must_topple = side > 1;
        const double exact = must_topple ? ratio : friction;
        const double rise = 30, rate = 1e-3 * gravity;
        const BaseMotion base{0.2, rise, 0.95 * exact * gravity, rate, 0.2 + rise + 0.1 * exact * gravity / rate};
        const Failure failure = shake(block, friction, base);
        const std::string name =
            fmt::format("b/h = {}, tan phi = {:.3g}: {}", ratio, friction, must_topple ? "topples" : "slides");
        report.judge({name + " at acceleration over gravity", "-", {}, exact, {}}, failure.acceleration / gravity,
                     Relative{0.01});
        report.judge({name + " (1 = topples)", "-", {}, must_topple ? 1.0 : 0.0, {}}, failure.is_toppling ? 1 : 0,
                     Absolute{0});
    }
}

}  // namespace riprap::validation::rigid
