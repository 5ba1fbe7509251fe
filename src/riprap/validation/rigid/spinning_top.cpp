// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include "riprap/geometry/convex_hull.hpp"
#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81;

}  // namespace

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
