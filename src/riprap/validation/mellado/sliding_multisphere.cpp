// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "riprap/solid/sphere_dem/sphere_world.hpp"
#include "riprap/validation/mellado/cases.hpp"

namespace riprap::validation::mellado {

namespace {

using solid::sphere_dem::SphereWorld;

constexpr double gravity = 9.81;

/// A flat block of spheres on a plane, gravity tilted by a slope.
SphereWorld block_on_plane(const contact::ContactMaterial& material, double slope, const Vec3& size, double sphere,
                           double density) {
    SphereWorld world;
    const MaterialId id = world.add_material(material);
    world.add_plane(id, {0, 0, 1}, {});
    world.add_multisphere(id, body::box_shell(size, sphere).value(), density, {{{0, 0, 0.5 * size.z}, {}}, {}, {}});
    world.gravity = {gravity * std::sin(slope), 0, -gravity * std::cos(slope)};
    return world;
}

/// Lets the block come to rest with springs that have not slipped: gravity turns from the normal to the slope.
void settle(SphereWorld& world, double dt) {
    const Vec3 tilted = world.gravity;
    world.gravity = {0, 0, tilted.z};
    world.settings.mass_damping = 200;
    for (int step = 0; step < 4000; ++step) {
        world.step(dt);
    }
    world.settings.mass_damping = 0;
    world.gravity = tilted;
}

void judge_sliding(double slope_deg, double friction, CaseReport& report) {
    const double slope = slope_deg * M_PI / 180;
    SphereWorld world = block_on_plane({.youngs_modulus = 1e8, .restitution = 0.3, .static_friction = friction}, slope,
                                       {0.2, 0.2, 0.05}, 0.0125, 900);
    world.build();
    const double dt = world.step_limit();
    settle(world, dt);
    const double x0 = world.state.position[1].x, begin = world.time;
    const bool slides = std::tan(slope) > friction;
    while (world.time < begin + 0.5) {
        world.step(dt);
    }
    const double exact = slides ? gravity * (std::sin(slope) - friction * std::cos(slope)) : 0;
    const std::string name = fmt::format("block of spheres on {} degrees, mu = {}", slope_deg, friction);
    if (slides) {
        report.judge({name + ": acceleration", "m/s^2", {}, exact, {}},
                     world.state.velocity[1].x / (world.time - begin), Relative{0.01});
    } else {
        // Moves by the stretch of its springs when gravity turns, then not at all.
        const double x1 = world.state.position[1].x;
        while (world.time < begin + 1.5) {
            world.step(dt);
        }
        report.judge_below({name + ": drift in the second after",
                            "m",
                            {},
                            0.0,
                            fmt::format("the springs stretched by {:.2g} m first", x1 - x0)},
                           world.state.position[1].x - x1, 1e-6);
    }
}

/// Speed at which the tanh friction lets a block creep.
void judge_creep(CaseReport& report) {
    const double slope = std::atan(0.3);
    SphereWorld world = block_on_plane({.youngs_modulus = 1e8, .restitution = 0.3, .static_friction = 0.412}, slope,
                                       {0.2, 0.2, 0.05}, 0.0125, 900);
    world.settings.tangential.choose<contact::TanhFriction>();
    world.build();
    const double dt = world.step_limit();
    settle(world, dt);
    const double begin = world.time;
    while (world.time < begin + 1) {
        world.step(dt);
    }
    report.judge({"tanh friction, tan(slope) = 0.3, mu = 0.412: creep", "m/s", {}, std::atanh(0.3 / 0.412) / 8, {}},
                 world.state.velocity[1].x, Relative{0.01});
}

}  // namespace

void sliding_multisphere(const CaseSetting&, CaseReport& report) {
    judge_sliding(30, 0.2, report);
    judge_sliding(25, 0.4, report);
    judge_sliding(20, 0.4, report);
    judge_creep(report);
    // A flat cube of 0.5 m and 150 kg that lands at 3.52 m/s.
    for (const int n : {2, 4, 8}) {
        SphereWorld world;
        const MaterialId wood = world.add_material({.youngs_modulus = 7e7, .poisson_ratio = 0.1, .restitution = 0.65});
        world.add_plane(wood, {0, 0, 1}, {});
        world.add_multisphere(wood, body::box_shell({0.5, 0.5, 0.5}, n).value(), 1200,
                              {{{0, 0, 0.2501}, {}}, {0, 0, -3.52}, {}});
        world.build();
        const double dt = world.step_limit();
        while (world.state.velocity[1].z < 0 || world.report.contact_count > 0) {
            world.step(dt);
        }
        report.judge({fmt::format("flat cube of {} spheres: restitution", n * n * n),
                      "-",
                      {},
                      0.65,
                      "LIGGGHTS-PUBLIC 3.8.0, where every contact counts in full: 0.087 with 488 spheres"},
                     world.state.velocity[1].z / 3.52, Relative{0.02});
    }
}

// Strips of wet polypropylene, the upper one weighted and pulled [Mellado2021, table 3.1].
void friction_strips(const CaseSetting&, CaseReport& report) {
    constexpr double friction = 0.412;
    for (const double grams : {1702.0, 2002.5, 2135.0, 2668.0}) {
        const double mass = 1e-3 * grams, density = mass / (0.2 * 0.05 * 0.01);
        SphereWorld world = block_on_plane({.youngs_modulus = 3.3e7,
                                            .poisson_ratio = 0.4,
                                            .restitution = 0.5,
                                            .static_friction = friction,
                                            .kinetic_friction = 0.35},
                                           0, {0.2, 0.05, 0.01}, 0.005, density);
        world.build();
        const double dt = world.step_limit();
        settle(world, dt);
        // The dynamometer: a pull that grows by a fifth of the weight every second, on the centre of mass.
        std::vector<Vec3> force(2), torque(2);
        const double begin = world.time, x0 = world.state.position[1].x;
        double pull = 0;
        while (world.time < begin + 4) {
            pull = 0.2 * mass * gravity * (world.time - begin) + 0.3 * mass * gravity;
            force[1] = {pull, 0, 0};
            world.step(dt, {force, torque});
            if (world.state.position[1].x - x0 > 1e-3) {
                break;
            }
        }
        report.judge({fmt::format("{} g: pull at break-away", grams),
                      "N",
                      {},
                      friction * mass * gravity,
                      "kinetic friction 0.35 once it slides"},
                     pull, Relative{0.02});
    }
}

}  // namespace riprap::validation::mellado
