// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/settle.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81, degree = M_PI / 180, dip = 35 * degree, friction_angle = 25 * degree, density = 2500;
constexpr double length = 2, width = 1,
                 height = 0.4;  ///< of the block, along the dip, along the strike, off the plane [m]

/// Holding and driving forces of the block, as shares of its weight.
struct Loads {
    double cohesion, uplift, thrust;  ///< c A/W, U/W normal to the plane, V/W in the tension crack, horizontal
};

double weight() { return density * length * width * height * gravity; }

/// F = [c A + (W cos psi - U - V sin psi) tan phi] / (W sin psi + V cos psi)
double safety(const Loads& loads) {
    const double normal = std::cos(dip) - loads.uplift - loads.thrust * std::sin(dip);
    return (loads.cohesion + normal * std::tan(friction_angle)) / (std::sin(dip) + loads.thrust * std::cos(dip));
}

/// @param strength  what tan phi and c are multiplied with
/// @returns how far the block has gone 2 s after it was let go [m]
double slide(const Loads& loads, double strength) {
    SceneBuilder scene;
    scene.add_material({.name = "rock",
                        .density = density,
                        .normal_stiffness = 1e9,
                        .friction = strength * std::tan(friction_angle),
                        .cohesion = strength * loads.cohesion * weight() / (length * width)});
    BodySpec plane;
    plane.name = "plane";
    plane.shape = scene.add_half_space({0, 0, 1}, 0);
    plane.drive = body::Drive::fixed;
    scene.add_body(plane);
    BodySpec block;
    block.name = "block";
    block.shape = scene.add_shape(geometry::box({length, width, height}));
    block.pose.position.z = 0.5 * height;
    const BodyId body = scene.add_body(block);
    scene.model.gravity.value = {gravity * std::sin(dip), 0, -gravity * std::cos(dip)};
    const Vec3 base{0, 0, -0.5 * height};
    scene.model.loads.push_back({.body = body, .force = {0, 0, loads.uplift * weight()}, .point = base});
    const double thrust = loads.thrust * weight();
    scene.model.loads.push_back({.body = body, .force = {thrust * std::cos(dip), 0, thrust * std::sin(dip)}});
    Trial trial(std::move(scene));
    trial.follow_energy(false);
    settle(trial);
    const double x0 = trial.position(body).x;
    trial.run_until(trial.time() + 2);
    return trial.position(body).x - x0;
}

}  // namespace

void plane_failure(const CaseSetting&, CaseReport& report) {
    const struct {
        const char* name;
        Loads loads;
    } cases[] = {{"friction and cohesion", {0.2, 0, 0}},
                 {"with water under it", {0.2, 0.15, 0}},
                 {"with water under and behind it", {0.2, 0.15, 0.1}}};
    for (const auto& one : cases) {
        const double factor = safety(one.loads);
        const std::string name = fmt::format("{}, F = {:.4f}: ", one.name, factor);
        report.judge_below({name + "motion in 2 s with strength over 0.99 F", "m", {}, {}, {}},
                           slide(one.loads, 1 / (0.99 * factor)), 1e-6);
        // Driven by what the strength lacks: (1 - 1/1.01) (W sin psi + V cos psi).
        const double driving = std::sin(dip) + one.loads.thrust * std::cos(dip);
        const double exact = 0.5 * 4 * gravity * driving * (1 - 1 / 1.01);
        report.judge({name + "with strength over 1.01 F", "m", {}, exact, {}}, slide(one.loads, 1 / (1.01 * factor)),
                     Relative{0.02});
    }
}

}  // namespace riprap::validation::rigid
