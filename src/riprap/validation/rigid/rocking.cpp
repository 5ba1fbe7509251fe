// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81;

/// A rigid block that rocks on two knife edges, c to the left and to the right of its middle [Housner1963, with
/// c = b]. theta is its tilt, positive when it stands on the left one.
///
///     I_O theta'' = -m g R sin(alpha - theta),   R^2 = c^2 + h^2,  tan(alpha) = c/h,  I_O = m ((b^2 + h^2)/3 + R^2)
struct RockingBlock {
    double half_width, half_height;  ///< b, h [m]
    double arm;                      ///< c [m]

    double radius() const { return std::hypot(arm, half_height); }
    double alpha() const { return std::atan2(arm, half_height); }
    /// I_cm/m [m^2]
    double own_inertia() const { return (half_width * half_width + half_height * half_height) / 3; }
    /// p^2 = m g R/I_O [1/s^2]
    double p_squared() const { return gravity * radius() / (own_inertia() + radius() * radius()); }

    /// Speed gained between the tilts `from` and `to`, squared: 2 p^2 (cos(alpha - to) - cos(alpha - from))
    /// with the sign of a fall [1/s^2].
    double gain(double from, double to) const {
        return 2 * p_squared() * (std::cos(alpha() - from) - std::cos(alpha() - to));
    }
    /// Time from rest at `tilt` to upright [s]: the integral of d theta/omega by the midpoint rule in
    /// theta = tilt (1 - u^2), which takes out the root at rest.
    double quarter_period(double tilt) const {
        constexpr int count = 20000;
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            const double u = (i + 0.5) / count, theta = tilt * (1 - u * u);
            sum += 2 * tilt * u / std::sqrt(gain(tilt, theta)) / count;
        }
        return sum;
    }
    /// omega after over omega before the change of foot: the angular momentum about the new foot is kept.
    double speed_ratio() const {
        const double r2 = radius() * radius(), h2 = half_height * half_height, c2 = arm * arm;
        return (own_inertia() + h2 - c2) / (own_inertia() + r2);
    }
    /// Tilt at which a block that starts upright with `omega` stops [rad].
    double peak(double omega) const {
        return alpha() - std::acos(std::min(1.0, std::cos(alpha()) + omega * omega / (2 * p_squared())));
    }
};

struct Rocking {
    double quarter{std::nan("")};  ///< from release to the touch of the second foot [s]
    double before{0}, after{0};    ///< speeds of the change of foot, both brought to upright [rad/s]
    double peak{0};                ///< on the other side [rad]
};

/// The knife edges are steep ridges of the ground, which a block sinks into by 1e-4 of its width. They give nothing
/// back (damping ratio 1 and no tension) and do not let the block slip.
SceneBuilder scene_of(const RockingBlock& block, double tilt) {
    SceneBuilder scene(true);
    scene.add_material({.name = "rock", .density = 2500, .normal_stiffness = 5e10, .friction = 2, .damping_ratio = 1});
    const double ridge = 0.1 * block.arm;
    const std::array<geometry::Point2, 3> corners{{{-ridge, -2 * ridge}, {ridge, -2 * ridge}, {0, 0}}};
    const ShapeId knife = scene.add_shape(geometry::planar_prism(corners));
    for (const double side : {-1.0, 1.0}) {
        BodySpec spec;
        spec.name = side < 0 ? "left" : "right";
        spec.shape = knife;
        spec.drive = body::Drive::fixed;
        spec.pose.position = {side * block.arm, 0, 0};
        scene.add_body(spec);
    }
    const double b = block.half_width, h = block.half_height;
    const std::array<geometry::Point2, 4> outline{{{-b, -h}, {b, -h}, {b, h}, {-b, h}}};
    BodySpec spec;
    spec.name = "block";
    spec.shape = scene.add_shape(geometry::planar_prism(outline));
    spec.pose.orientation = turn({0, 0, 1}, tilt);
    spec.pose.position = Vec3{-block.arm, 0, 0} + rotate(spec.pose.orientation, Vec3{block.arm, h, 0});
    scene.add_body(spec);
    scene.model.gravity.value = {0, -gravity, 0};
    return scene;
}

Rocking rock(const RockingBlock& block, double tilt) {
    Trial trial(scene_of(block, tilt));
    trial.follow_energy(false);
    constexpr BodyId body{2};
    constexpr int right = 1;
    Rocking result;
    const double limit = 4 * block.quarter_period(tilt);
    double omega = 0, theta = tilt, last_theta = tilt;
    while (trial.time() < limit) {
        trial.step();
        bool on_right = false;
        for (const contact::ShownContact& row : trial.contacts()) {
            on_right |= std::min(row.a, row.b).value == right;
        }
        last_theta = theta;
        theta = to_rotation_vector(trial.orientation(body)).z;
        if (on_right && std::isnan(result.quarter)) {
            result.quarter = trial.time();
            result.before = std::sqrt(omega * omega + block.gain(last_theta, 0));
        }
        omega = trial.angular_velocity(body).z;
        if (theta < -0.1 * tilt && result.after == 0) {  // the impact is over
            result.after = std::sqrt(omega * omega + block.gain(-theta, 0));
        }
        result.peak = std::max(result.peak, std::isnan(result.quarter) ? 0.0 : -theta);
        if (result.after > 0 && omega > 0) {
            break;  // on the way back
        }
    }
    return result;
}

}  // namespace

void rocking(const CaseSetting&, CaseReport& report) {
    struct Size {
        double b, h;
    };
    for (const Size& size : {Size{0.25, 1}, Size{0.1, 0.5}}) {
        const RockingBlock housner{size.b, size.h, size.b}, block{size.b, size.h, 0.996 * size.b};
        const double tilt = 0.5 * block.alpha();
        const Rocking ours = rock(block, tilt);
        const std::string name = fmt::format("b = {}, h = {} m: ", size.b, size.h);
        const double quarter = block.quarter_period(tilt), falling = std::sqrt(block.gain(tilt, 0));
        report.judge({name + "quarter period", "s", housner.quarter_period(0.5 * housner.alpha()), quarter, {}},
                     ours.quarter, Relative{0.005});
        report.judge(
            {name + "speed after over before the change of foot", "-", housner.speed_ratio(), block.speed_ratio(), {}},
            ours.after / ours.before, Relative{0.01});
        report.judge({name + "next peak",
                      "rad",
                      housner.peak(housner.speed_ratio() * std::sqrt(housner.gain(0.5 * housner.alpha(), 0))),
                      block.peak(block.speed_ratio() * falling),
                      {}},
                     ours.peak, Relative{0.02});
    }
}

}  // namespace riprap::validation::rigid
