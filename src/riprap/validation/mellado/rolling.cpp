// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "riprap/contact/law/hertz.hpp"
#include "riprap/solid/sphere_dem/sphere_world.hpp"
#include "riprap/validation/mellado/cases.hpp"

namespace riprap::validation::mellado {

namespace {

using solid::sphere_dem::SphereWorld;

constexpr double gravity = 9.81, radius = 0.05, mass = 1.0;

/// Depth at which a sphere rests under the force `weight` [m].
double rest_depth(double modulus, double weight) {
    return std::pow(weight / (4.0 / 3 * modulus * std::sqrt(radius)), 2.0 / 3);
}

/// A sphere or disc at rest depth on a plane that tilts gravity.
SphereWorld on_slope(bool is_disc, double slope, double friction, const Vec3& velocity) {
    SphereWorld world;
    const contact::ContactMaterial material{.youngs_modulus = 1e9, .restitution = 0.5, .static_friction = friction};
    const MaterialId grain = world.add_material(material);
    const double weight = mass * gravity * std::cos(slope);
    const double height = radius - rest_depth(contact::effective_modulus({1e9, 0.3}, {1e9, 0.3}), weight);
    world.add_plane(grain, {0, 1, 0}, {});
    const solid::sphere_dem::Start start{{{0, height, 0}, {}}, velocity, {}};
    if (is_disc) {
        world.add_disc(grain, radius, mass, start);
    } else {
        world.add_sphere(grain, radius, mass, start);
    }
    world.gravity = {gravity * std::sin(slope), -gravity * std::cos(slope), 0};
    world.build();
    return world;
}

void run(SphereWorld& world, double end) {
    const double dt = world.step_limit();
    while (world.time < end) {
        world.step(dt);
    }
}

void judge_slope(bool is_disc, double slope_deg, double friction, CaseReport& report) {
    const double slope = slope_deg * M_PI / 180;
    SphereWorld world = on_slope(is_disc, slope, friction, {});
    run(world, 0.5);
    const double limit = std::tan(slope) / (is_disc ? 3 : 3.5);
    const bool rolls = friction >= limit;
    const double exact = rolls ? (is_disc ? 2.0 / 3 : 5.0 / 7) * gravity * std::sin(slope)
                               : gravity * (std::sin(slope) - friction * std::cos(slope));
    const std::string name = fmt::format("{} on {} degrees, mu = {}", is_disc ? "disc" : "sphere", slope_deg, friction);
    report.judge({name + ": acceleration", "m/s^2", {}, exact, {}}, world.state.velocity[1].x / world.time,
                 Relative{2e-3});
    if (!rolls) {
        const double spin = angular_velocity(world.bodies, world.state, BodyId{1}).z;
        report.judge({name + ": spin rate",
                      "rad/s^2",
                      {},
                      (is_disc ? 2.0 : 2.5) * friction * gravity * std::cos(slope) / radius,
                      {}},
                     -spin / world.time, Relative{2e-3});
    }
}

/// Peaks and time of rest of a ball that is dropped from 1 m.
void judge_bounces(double e, CaseReport& report) {
    SphereWorld world;
    const MaterialId grain = world.add_material({.youngs_modulus = 1e10, .restitution = e});
    world.add_plane(grain, {0, 0, 1}, {});
    world.add_sphere(grain, radius, mass, {{{0, 0, radius + 1}, {}}, {}, {}});
    world.gravity = {0, 0, -gravity};
    world.settings.steps_per_contact = 100;  // of an impact at the speed of a fall over one diameter
    world.build();
    const double dt = world.step_limit();
    const double exact_rest = std::sqrt(2 / gravity) * (1 + e) / (1 - e);
    std::vector<double> peaks;
    double previous = 0, rest = 0;
    while (world.time < 1.3 * exact_rest) {
        world.step(dt);
        const double v = world.state.velocity[1].z, height = world.state.position[1].z - radius;
        if (previous > 0 && v <= 0 && height > 0 && peaks.size() < 3) {
            peaks.push_back(height);
        }
        if (std::abs(v) > 0.01 || height > 1e-5) {
            rest = world.time;
        }
        previous = v;
    }
    peaks.resize(3);
    for (std::size_t n = 0; n < 3; ++n) {
        report.judge({fmt::format("ball dropped from 1 m, e = {}: peak {}", e, n + 1),
                      "m",
                      {},
                      std::pow(e, 2.0 * static_cast<double>(n + 1)),
                      {}},
                     peaks[n], Relative{0.01});
    }
    report.judge({fmt::format("ball dropped from 1 m, e = {}: comes to rest", e), "s", {}, exact_rest, {}}, rest,
                 Relative{0.02});
}

/// Largest energy over the first, at the peaks of an elastic ball.
double elastic_gain(int bounces) {
    SphereWorld world;
    const MaterialId grain = world.add_material({.youngs_modulus = 1e8, .restitution = 1});
    world.add_plane(grain, {0, 0, 1}, {});
    world.add_sphere(grain, radius, mass, {{{0, 0, radius + 0.1}, {}}, {}, {}});
    world.gravity = {0, 0, -gravity};
    world.settings.steps_per_contact = 400;
    world.build();
    const double dt = world.step_limit();
    double worst = 0, previous = 0;
    for (int count = 0; count < bounces;) {
        world.step(dt);
        const double v = world.state.velocity[1].z;
        if (previous > 0 && v <= 0) {
            worst = std::max(worst, std::abs((world.state.position[1].z - radius) / 0.1 - 1));
            ++count;
        }
        previous = v;
    }
    return worst;
}

}  // namespace

void rolling(const CaseSetting&, CaseReport& report) {
    judge_slope(false, 20, 0.4, report);
    judge_slope(false, 40, 0.1, report);
    judge_slope(true, 20, 0.4, report);
    judge_slope(true, 40, 0.1, report);
    const double mu = 0.2, v0 = 2;
    SphereWorld world = on_slope(false, 0, mu, {v0, 0, 0});
    const double taken_up = 2 * v0 / (7 * mu * gravity);
    run(world, 0.9 * taken_up);
    report.judge({"sliding sphere: speed before it rolls", "m/s", {}, v0 - mu * gravity * world.time, {}},
                 world.state.velocity[1].x, Relative{5e-3});
    run(world, 1.2 * taken_up);
    report.judge({"sliding sphere: speed once it rolls", "m/s", {}, 5 * v0 / 7, {}}, world.state.velocity[1].x,
                 Relative{5e-3});
    judge_bounces(0.5, report);
    judge_bounces(0.8, report);
    report.judge_below({"elastic ball: change of energy over 100 bounces, over the energy", "-", {}, 0.0, {}},
                       elastic_gain(100), 1e-4);
}

}  // namespace riprap::validation::mellado
