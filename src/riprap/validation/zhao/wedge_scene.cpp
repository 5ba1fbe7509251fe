// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/zhao/wedge_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "riprap/geometry/convex_hull.hpp"

namespace riprap::validation::zhao {

namespace {

constexpr double gravity = 9.81;  // [m/s^2]

struct WedgeScene {
    SceneBuilder scene;
    BodyId wedge, ground;
};

/// Cross-section in the plane of y and m: apex at the origin, flat top at m = depth.
geometry::Outcome<geometry::Polyhedron> wedge_shape(const WedgeSetting& s, const WedgeTheory& theory) {
    std::vector<Vec3> corners;
    for (const double end : {0.0, s.length}) {
        corners.push_back(end * theory.along);
        corners.push_back(end * theory.along + s.depth * theory.across + Vec3{0, s.depth * std::tan(s.left_angle), 0});
        corners.push_back(end * theory.along + s.depth * theory.across - Vec3{0, s.depth * std::tan(s.right_angle), 0});
    }
    return geometry::convex_hull(corners);
}

/// Steps of the settling phase. With the damping used, c = 0.1/dt, a mode ten times slower than the fastest one still
/// decays by exp(-18).
constexpr int settling_steps = 2000;

WedgeScene build(const WedgeSetting& s, const WedgeTheory& theory) {
    WedgeScene built;
    SceneBuilder& scene = built.scene;
    scene.add_material({.name = "rock",
                        .density = s.density,
                        .normal_stiffness = s.stiffness,
                        .shear_ratio = s.shear_ratio,
                        .friction = s.friction});
    BodySpec wall;
    if (s.shake > 0) {
        // Ground acceleration -A sin(omega t): the wedge is thrown forward by A sin(omega t).
        const double omega = 2 * M_PI / s.period;
        wall.drive = body::Drive::driven;
        wall.motion = {body::SinusoidalMotion{{s.shake / (omega * omega), 0, 0}, s.period, 0},
                       std::numeric_limits<double>::max()};  // starts when the wedge has settled
    } else {
        wall.drive = body::Drive::fixed;
    }
    const Vec3 left_in = std::sin(s.left_angle) * theory.across - Vec3{0, std::cos(s.left_angle), 0};
    const Vec3 right_in = std::sin(s.right_angle) * theory.across + Vec3{0, std::cos(s.right_angle), 0};
    wall.name = "left_plane";
    wall.shape = scene.add_half_space(left_in, 0);
    built.ground = scene.add_body(wall);
    wall.name = "right_plane";
    wall.shape = scene.add_half_space(right_in, 0);
    scene.add_body(wall);
    BodySpec block;
    block.name = "wedge";
    block.shape = scene.add_shape(wedge_shape(s, theory));
    built.wedge = scene.add_body(block);
    scene.model.gravity.value = -gravity * std::cos(s.plunge) * theory.across;
    return built;
}

}  // namespace

WedgeTheory wedge_theory(const WedgeSetting& s) {
    WedgeTheory theory{};
    theory.along = {std::cos(s.plunge), 0, -std::sin(s.plunge)};
    theory.across = {std::sin(s.plunge), 0, std::cos(s.plunge)};
    // N1 cos(a1) = N2 cos(a2), N1 sin(a1) + N2 sin(a2) = W cos(theta).
    const double sum = std::sin(s.left_angle + s.right_angle);
    theory.load_left = std::cos(s.plunge) * std::cos(s.right_angle) / sum;
    theory.load_right = std::cos(s.plunge) * std::cos(s.left_angle) / sum;
    const double resistance = s.friction * (theory.load_left + theory.load_right);
    theory.acceleration = gravity * std::max(0.0, std::sin(s.plunge) - resistance);
    return theory;
}

WedgeTrial::WedgeTrial(const WedgeSetting& s)
    : trial([&] { return Trial(build(s, wedge_theory(s)).scene); }()), theory(wedge_theory(s)) {
    wedge = trial.body("wedge");
    ground_ = trial.body("left_plane");
    trial.follow_energy(false);
    sim::Model& model = trial.model();
    const auto settle = [this] {
        trial.model().dem()->mass_damping = 0.1 / trial.dt();
        for (int i = 0; i < settling_steps; ++i) {
            trial.step();
        }
        trial.model().dem()->mass_damping = 0;
    };
    settle();
    model.gravity.value = {0, 0, -gravity};
    if (theory.acceleration == 0) {
        settle();  // friction holds the wedge: its springs carry the load before anything moves
    }
    if (s.shake > 0) {
        // The ground starts at its highest speed, A/omega; the wedge is given the same.
        for (body::PrescribedMotion& motion : model.bodies.motions) {
            motion.start = trial.time();
        }
        trial.state().bodies.velocity[static_cast<std::size_t>(wedge.value)].x += s.shake * s.period / (2 * M_PI);
    }
    start = trial.time();
    start_position = trial.position(wedge);
    start_orientation = trial.orientation(wedge);
    ground_start_ = trial.position(ground_);
}

Vec3 WedgeTrial::displacement() const {
    return trial.position(wedge) - start_position - (trial.position(ground_) - ground_start_);
}
Vec3 WedgeTrial::velocity() const { return trial.velocity(wedge) - trial.velocity(ground_); }
double WedgeTrial::rotation() const {
    return norm(to_rotation_vector(normalized(trial.orientation(wedge) * conjugate(start_orientation))));
}

}  // namespace riprap::validation::zhao
