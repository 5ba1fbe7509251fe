// SPDX-License-Identifier: Apache-2.0
// Bodies that turn about a point that contact and friction hold: a pendulum on a knife edge, a top on its tip.
#include <algorithm>
#include <cmath>
#include <vector>

#include "riprap/geometry/convex_hull.hpp"
#include "riprap/validation/case_trial.hpp"
#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81;

/// Moments per area of the staple of case.toml about the knife edge: mass over density [m^2], first moment below the
/// edge [m^3], second moment [m^4].
struct Staple {
    double area{0}, below{0}, second{0};

    void add(double width, double height, double x, double y) {
        const double a = width * height;
        area += a;
        below -= a * y;
        second += a * ((width * width + height * height) / 12 + x * x + y * y);
    }
    /// 2 pi sqrt(I_O/(m g d)) for small swings [s]
    double period() const { return 2 * M_PI * std::sqrt(second / (gravity * below)); }
};

}  // namespace

void pendulum(const CaseSetting& setting, CaseReport& report) {
    constexpr double tilt = 0.03;  // its square over 16 is 6e-5 of the period
    Staple staple;
    staple.add(0.6, 0.1, 0, 0.05);
    staple.add(0.1, 0.9, -0.25, -0.45);
    staple.add(0.1, 0.9, 0.25, -0.45);
    Trial trial = trial_of(setting);
    trial.follow_energy(false);
    const BodyId body = trial.body("staple");
    const auto b = static_cast<std::size_t>(body.value);
    // Turned about the edge, at rest.
    const Quat turned = turn({0, 0, 1}, tilt);
    trial.state().bodies.position[b] = rotate(turned, trial.state().bodies.position[b]);
    trial.state().bodies.orientation[b] = turned * trial.state().bodies.orientation[b];
    std::vector<double> crossings;
    double before = tilt;
    trial.run_until(8, [&](const Trial& now) {
        const double angle = to_rotation_vector(now.orientation(body)).z;
        if (before * angle < 0) {
            crossings.push_back(now.time() - now.dt() * angle / (angle - before));
        }
        before = angle;
    });
    const double exact = staple.period() * (1 + tilt * tilt / 16);
    report.judge({"period of a pendulum on a knife edge", "s", {}, exact, "2 pi sqrt(I_O/(m g d))"},
                 crossings.size() > 2
                     ? 2 * (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1)
                     : std::nan(""),
                 Relative{1e-3});
}

void spinning_top(const CaseSetting&, CaseReport& report) {
    // A pyramid of 24 sides that stands on its tip, spun fast: a symmetric top.
    constexpr double radius = 0.1, height = 0.1, tilt = 20 * M_PI / 180, spin = 200;
    constexpr int sides = 24;
    std::vector<Vec3> corners{{0, 0, 0}};
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * M_PI * i / sides;
        corners.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
    }
    // The tip is a cone that sinks by d = (N r/(1.18 k))^(1/3), r the radius that scales the potential. The pressure on
    // its cut passes 0.72 d to the side of the lean, which shortens the arm of gravity, and friction holds the cut
    // 0.33 d beside the axis of spin: the tip rolls on a small circle. Either slows precession: by 3.0, 1.2 and 0.2 %
    // in all at k = 1e10, 1e11 and 1e12 Pa. The step is that of a body on its tip, whose frequency is sqrt(3 g/d)/2 pi,
    // not the one that a body covered all over would need; half of it changes the fifth digit.
    SceneBuilder scene;
    scene.add_material({.name = "rock", .density = 2500, .normal_stiffness = 1e12, .friction = 1});
    BodySpec ground;
    ground.name = "ground";
    ground.shape = scene.add_half_space({0, 0, 1}, 0);
    ground.drive = body::Drive::fixed;
    scene.add_body(ground);
    BodySpec spec;
    spec.name = "top";
    spec.shape = scene.add_shape(geometry::convex_hull(corners));
    spec.pose.orientation = turn({0, 1, 0}, tilt);
    const BodyId top = scene.add_body(spec);
    scene.model.gravity.value = {0, 0, -gravity};
    scene.model.time.time_step = 1e-5;
    scene.model.time.force_time_step = true;
    const auto b = static_cast<std::size_t>(top.value);
    const double mass = scene.model.bodies.mass[b], arm = 0.75 * height;  // centre of a pyramid from its tip
    const Vec3 moments = scene.model.bodies.principal_moments[b];
    const double axial = std::max({moments.x, moments.y, moments.z});
    const double across = 0.5 * (moments.x + moments.y + moments.z - axial) + mass * arm * arm;  // about the tip
    // Steady precession: I_3 s W - I_1 W^2 cos(tilt) = m g l, its slow root.
    const double c = std::cos(tilt), load = mass * gravity * arm;
    const double rate = 2 * load / (axial * spin + std::sqrt(axial * axial * spin * spin - 4 * across * c * load));
    const Vec3 axis = rotate(spec.pose.orientation, Vec3{0, 0, 1});
    const Vec3 omega = Vec3{0, 0, rate} + (spin - rate * c) * axis;
    scene.state.bodies.velocity[b] = cross(omega, arm * axis);
    scene.state.bodies.angular_momentum[b] =
        body::angular_momentum_of(scene.model.bodies, top, scene.state.bodies.orientation[b], omega);
    Trial trial(std::move(scene));
    trial.follow_energy(false);
    const auto azimuth = [&] {
        const Vec3 now = trial.position(top);
        return std::atan2(now.y, now.x);
    };
    // The tip does not slip; nutation, excited as the tip takes up the weight, is left out by the mean of many of its
    // turns.
    double turned = 0, last = azimuth(), start = 0;
    trial.run_until(0.9, [&](const Trial& now) {
        const Vec3 tip = now.position(top) - arm * rotate(now.orientation(top), Vec3{0, 0, 1});
        const Vec3 above = now.position(top) - tip;
        const double angle = std::atan2(above.y, above.x);
        if (now.time() > 0.1) {
            start = start == 0 ? now.time() : start;
            turned += std::remainder(angle - last, 2 * M_PI);
        }
        last = angle;
    });
    report.judge({"precession of a top on its tip", "rad/s", {}, rate, "steady; m g l/(I_3 s) to first order"},
                 turned / (trial.time() - start), Relative{0.01});
}

}  // namespace riprap::validation::rigid
