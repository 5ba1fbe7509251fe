// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/solid/sphere_dem/sphere_world.hpp"
#include "riprap/validation/mellado/cases.hpp"

namespace riprap::validation::mellado {

namespace {

using solid::sphere_dem::SphereWorld;

constexpr double edge = 0.5, sphere_radius = 0.025, density = 1200, gravity = 9.81;

/// Soft wood and steel of the demolisher [Mellado2021, table 4.6].
contact::ContactMaterial wood() {
    return {.youngs_modulus = 7e7, .poisson_ratio = 0.1, .restitution = 0.5, .static_friction = 0.75};
}
contact::ContactMaterial steel() {
    return {.youngs_modulus = 2.1e11, .poisson_ratio = 0.3, .restitution = 0.8, .static_friction = 0.45};
}

std::size_t add_block(SphereWorld& world, MaterialId material, const Vec3& place) {
    const body::Multisphere cube = body::box_shell({edge, edge, edge}, sphere_radius).value();
    return static_cast<std::size_t>(world.add_multisphere(material, cube, density, {{place, {}}, {}, {}}).value);
}

void look_after(const SphereWorld& world, double end, const CaseSetting& setting) {
    const auto& report = world.report;
    if (!report.problem.empty()) {
        throw std::runtime_error(fmt::format("at {:.4f} s: {}", world.time, report.problem));
    }
    if (setting.after_step) {
        setting.after_step(world.time, end);
    }
}

/// Books of a run: energy that the accounts miss over what was turned over, momentum that the impulses miss.
struct Books {
    double first_energy{0}, highest_kinetic{0}, worst_energy{0};
    Vec3 first_momentum{}, impulse{};
    double momentum_scale{0}, worst_momentum{0};
    bool has_begun{false};

    void look(const SphereWorld& world) {
        const solid::KickReport& kick = world.report.kick;
        if (!has_begun) {
            has_begun = true;
            first_energy = world.energy_account();
            // Momentum is measured in the middle of a kick, its impulse goes from there to the next one's middle.
            first_momentum = kick.momentum - 0.5 * kick.impulse;
        }
        impulse += kick.impulse;
        const Vec3 missed = kick.momentum - 0.5 * kick.impulse - first_momentum - (impulse - kick.impulse);
        highest_kinetic = std::max(highest_kinetic, kick.kinetic);
        momentum_scale = std::max(momentum_scale, norm(impulse));
        worst_energy = std::max(worst_energy, std::abs(world.energy_account() - first_energy));
        worst_momentum = std::max(worst_momentum, norm(missed));
    }
    void judge(CaseReport& report) const {
        report.judge_below(
            {"energy that the accounts miss, over the highest kinetic energy", "-", {}, 0.0, {}, Kind::bookkeeping},
            worst_energy / highest_kinetic, 0.02);
        report.judge_below({"momentum that the impulses miss, over all impulse", "-", {}, 0.0, {}, Kind::bookkeeping},
                           worst_momentum / momentum_scale, 1e-9);
    }
};

}  // namespace

namespace {

/// Sixteen blocks and the ball [Mellado2021, 4.6.3]; positions, pivot and string are ours.
struct Demolition {
    SphereWorld world;
    std::size_t floor{0}, ball{0};
    std::vector<std::size_t> blocks;
    Vec3 pivot{3.40, 5.25, 7.75};
    double string{7};
};

Demolition make_demolition(bool is_prescribed) {
    Demolition d;
    SphereWorld& world = d.world;
    const MaterialId block = world.add_material(wood()), metal = world.add_material(steel());
    d.floor = static_cast<std::size_t>(world.add_plane(metal, {0, 0, 1}, {}).value);
    world.add_plane(metal, {1, 0, 0}, {});
    world.add_plane(metal, {-1, 0, 0}, {11, 0, 0});
    world.add_plane(metal, {0, 1, 0}, {0, 2, 0});
    world.add_plane(metal, {0, -1, 0}, {0, 8, 0});
    for (int row = 0; row < 3; ++row) {
        for (int k = 0; k < 5; ++k) {
            d.blocks.push_back(add_block(world, block, {4, 5 + 0.501 * (k - 2), 0.25 + 0.5 * row}));
        }
    }
    d.blocks.push_back(add_block(world, block, {4, 5, 1.75}));
    const double angle = 25 * M_PI / 180, speed = std::sqrt(2 * gravity * d.string * (1 - std::cos(angle)));
    const Vec3 start = d.pivot + d.string * Vec3{-std::sin(angle), 0, -std::cos(angle)};
    const double mass = 2500 * M_PI / 6 * std::pow(0.7, 3);
    const BodyId ball = world.add_sphere(metal, 0.35, mass, {{start, {}}, {}, {}});
    d.ball = static_cast<std::size_t>(ball.value);
    if (is_prescribed) {
        // Swings towards +x: about -y, at the speed with which the free ball would arrive, through 50 degrees.
        const double rate = speed / d.string;
        world.bodies.motions.push_back(
            {body::RotatingMotion{.center = d.pivot, .axis = {0, -1, 0}, .rate = rate}, 0, 2 * angle / rate});
        world.bodies.drive[d.ball] = body::Drive::driven;
        body::drive(world.bodies, ball, static_cast<std::int32_t>(world.bodies.motions.size()) - 1, {start, {}});
    }
    world.gravity = {0, 0, -gravity};
    world.settings.max_overlap = 2;  // by Hertz the ball goes 28 mm into a sphere of 25 mm
    world.build();
    return d;
}

/// Pull of the string where it is taut [N]: a spring that gives by 1e-4 of its length under five weights of the ball.
Vec3 string_force(const Demolition& d) {
    const Vec3 r = d.world.state.position[d.ball] - d.pivot;
    const double weight = d.world.bodies.mass[d.ball] * gravity, stiffness = 5 * weight / (1e-4 * d.string);
    const double stretch = norm(r) - d.string;
    return stretch > 0 ? r * (-stiffness * stretch / norm(r)) : Vec3{};
}

struct Swing {
    Vec3 mean{}, final{};
    double contact_impulse{0}, momentum_change{0}, arrival{0};
    Books books;
};

Swing run_demolition(bool is_prescribed, const CaseSetting& setting) {
    Demolition d = make_demolition(is_prescribed);
    SphereWorld& world = d.world;
    const double end = 4;
    const double mass = world.bodies.mass[d.ball];
    std::vector<Vec3> force(at(world.bodies.size())), torque(force.size());
    Swing swing;
    std::int64_t count = 0;
    double dt = 0;
    Vec3 contact_impulse{}, other_impulse{}, first{};
    for (std::int64_t n = 0; world.time < end; ++n) {
        if (n % 1000 == 0) {
            dt = std::min(world.step_limit(), 2e-4);
        }
        force[d.ball] = is_prescribed ? Vec3{} : string_force(d);
        if (is_prescribed) {
            world.step(dt);
        } else {
            world.step(dt, {force, torque});
        }
        look_after(world, end, setting);
        swing.books.look(world);
        const Vec3 touch = world.scratch.loads.force[d.ball];
        contact_impulse += dt * touch;
        other_impulse += dt * (force[d.ball] + mass * world.gravity);
        if (swing.arrival == 0 && norm(touch) > 0) {
            swing.arrival = norm(world.state.velocity[d.ball]);
        }
        Vec3 sum{};
        for (const std::size_t b : d.blocks) {
            sum += world.state.position[b];
        }
        swing.final = sum / static_cast<double>(d.blocks.size());
        swing.mean += swing.final;
        ++count;
    }
    swing.mean = swing.mean / static_cast<double>(count);
    swing.contact_impulse = norm(contact_impulse);
    swing.momentum_change = norm(mass * world.state.velocity[d.ball] - first - other_impulse);
    return swing;
}

}  // namespace

void demolisher(const CaseSetting& setting, CaseReport& report) {
    constexpr std::array thesis{4.53, 5.06, 0.79}, liggghts{4.48, 4.92, 0.76}, dual{4.78, 5.07, 0.81};
    const Swing driven = run_demolition(true, setting);
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        report.judge({fmt::format("prescribed swing: mean {} of the blocks over 4 s", "xyz"[axis]),
                      "m",
                      thesis[k],
                      {},
                      fmt::format("LIGGGHTS {} m, DualSPHysics {} m; positions, pivot and speed are ours, the sources "
                                  "print none",
                                  liggghts[k], dual[k])},
                     driven.mean[axis], liggghts[k] * (1 - 0.065), liggghts[k] * (1 + 0.065));
        report.state({fmt::format("prescribed swing: mean {} of the blocks at the end", "xyz"[axis]), "m", ""},
                     driven.final[axis]);
    }
    driven.books.judge(report);
    const Swing free = run_demolition(false, setting);
    const double angle = 25 * M_PI / 180;
    report.judge({"free swing: speed of the ball as it arrives",
                  "m/s",
                  {},
                  std::sqrt(2 * gravity * 7 * (1 - std::cos(angle))),
                  {}},
                 free.arrival, Relative{0.02});
    report.judge({"free swing: impulse of the blocks on the ball over its change of momentum", "-", {}, 1.0, {}},
                 free.contact_impulse / free.momentum_change, Relative{0.01});
    for (int axis = 0; axis < 3; ++axis) {
        const double other = dual[static_cast<std::size_t>(axis)];  // its ball hangs on a chain and falls, too
        report.judge({fmt::format("free swing: mean {} of the blocks over 4 s", "xyz"[axis]),
                      "m",
                      other,
                      {},
                      "DualSPHysics, by gravity as well; positions, pivot and string are ours, the sources print none"},
                     free.mean[axis], other * (1 - 0.065), other * (1 + 0.065));
        report.state({fmt::format("free swing: mean {} of the blocks at the end", "xyz"[axis]), "m", ""},
                     free.final[axis]);
    }
    free.books.judge(report);
}

}  // namespace riprap::validation::mellado
