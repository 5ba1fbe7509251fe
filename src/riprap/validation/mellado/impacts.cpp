// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "riprap/contact/law/hertz.hpp"
#include "riprap/solid/sphere_dem/sphere_world.hpp"
#include "riprap/validation/mellado/cases.hpp"
#include "riprap/validation/mellado/chung_ooi.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::mellado {

namespace {

using chung_ooi::Line;
using solid::sphere_dem::SphereWorld;

constexpr double rigid_modulus = 1e22;  ///< [Pa]

/// A grain of a material.
struct Grain {
    const char* name;
    double modulus, poisson_ratio, density, radius;
    double mass() const { return density * 4.0 / 3 * M_PI * radius * radius * radius; }
};

/// Extremes of one impact.
struct Impact {
    double depth{0}, force{0}, duration{0};
    Vec3 velocity{}, spin{};
    std::vector<double> depths, forces;  ///< in the middle of each step until the deepest [m], [N]
};

/// Steps until the bodies have parted. `moving` is the body that is watched, `other` the one it meets.
Impact run_impact(SphereWorld& world, double dt, std::size_t moving, const auto& depth_of) {
    Impact impact;
    bool has_touched = false;
    double last = depth_of();
    for (int step = 0; step < 10'000'000; ++step) {
        world.step(dt);
        const double depth = depth_of(), force = norm(world.scratch.loads.force[moving]);
        if (depth > last) {
            impact.depths.push_back(0.5 * (depth + last));
            impact.forces.push_back(force);
        }
        last = depth;
        impact.depth = std::max(impact.depth, depth);
        impact.force = std::max(impact.force, force);
        has_touched = has_touched || world.report.contact_count > 0;
        impact.duration += world.report.contact_count > 0 ? dt : 0;
        if (has_touched && world.report.contact_count == 0) {
            break;
        }
    }
    impact.velocity = world.state.velocity[moving];
    impact.spin = angular_velocity(world.bodies, world.state, BodyId{static_cast<std::int32_t>(moving)});
    return impact;
}

/// A sphere that meets the plane z = 0, which does not give.
struct PlaneThrow {
    Grain grain;
    double restitution{1}, friction{0};
    Vec3 velocity{}, spin{};
    double steps{200};
    bool allows_pull{true};
};

Impact on_plane(const PlaneThrow& t) {
    SphereWorld world;
    const contact::ContactMaterial soft{.youngs_modulus = t.grain.modulus,
                                        .poisson_ratio = t.grain.poisson_ratio,
                                        .restitution = t.restitution,
                                        .static_friction = t.friction};
    contact::ContactMaterial hard = soft;
    hard.youngs_modulus = rigid_modulus;
    const MaterialId grain = world.add_material(soft), plate = world.add_material(hard);
    world.add_plane(plate, {0, 0, 1}, {});
    world.add_sphere(grain, t.grain.radius, t.grain.mass(), {{{0, 0, t.grain.radius}, {}}, t.velocity, t.spin});
    world.settings.allows_pull = t.allows_pull;
    world.settings.max_speed = 1e9;
    world.build();
    const double modulus = t.grain.modulus / (1 - t.grain.poisson_ratio * t.grain.poisson_ratio);
    const double duration =
        contact::hertz_contact_time(modulus, t.grain.radius, t.grain.mass(), std::abs(t.velocity.z));
    return run_impact(world, duration / t.steps, 1, [&] { return t.grain.radius - world.state.position[1].z; });
}

Impact two_spheres(const Grain& g, double speed) {
    SphereWorld world;
    const MaterialId material = world.add_material({.youngs_modulus = g.modulus, .poisson_ratio = g.poisson_ratio});
    world.add_sphere(material, g.radius, g.mass(), {{{0, 0, 0}, {}}, {speed, 0, 0}, {}});
    world.add_sphere(material, g.radius, g.mass(), {{{2 * g.radius, 0, 0}, {}}, {-speed, 0, 0}, {}});
    world.build();
    const double modulus = g.modulus / (2 * (1 - g.poisson_ratio * g.poisson_ratio));
    const double duration = contact::hertz_contact_time(modulus, 0.5 * g.radius, 0.5 * g.mass(), 2 * speed);
    return run_impact(world, duration / 200, 0,
                      [&] { return 2 * g.radius - norm(world.state.position[1] - world.state.position[0]); });
}

/// Depth, force and duration beside Hertz.
void judge_hertz(const std::string& name, const Impact& impact, double modulus, double radius, double mass,
                 double speed, CaseReport& report) {
    const double depth = contact::hertz_largest_overlap(modulus, radius, mass, speed);
    const double force = contact::hertz<double>({modulus, radius, mass, 0}, depth).elastic;
    report.judge({name + ", deepest overlap", "um", {}, 1e6 * depth, {}}, 1e6 * impact.depth, Relative{1e-3});
    report.judge({name + ", largest force", "kN", {}, 1e-3 * force, {}}, 1e-3 * impact.force, Relative{1e-3});
    const double duration = contact::hertz_contact_time(modulus, radius, mass, speed);
    // Steps see the contact at their middles: the count of steps in contact is right to one of 200.
    report.judge({name + ", duration", "us", {}, 1e6 * duration, "counted in steps of 1/200"}, 1e6 * impact.duration,
                 Relative{5e-3});
}

/// Force beside every line of the published curve, as the spheres approach.
void judge_curve(const std::string& name, const Impact& impact, std::span<const Line> curve, CaseReport& report) {
    for (const Line& line : curve) {
        report.judge({fmt::format("{}, force at an overlap of {} um", name, line.x),
                      "kN",
                      line.y,
                      {},
                      "1 % of the largest force, the reading of the figure"},
                     1e-3 * water::interpolated(impact.depths, impact.forces, 1e-6 * line.x), line.y - 0.107,
                     line.y + 0.107);
    }
}

/// A figure of test 5 [ChungOoi2011]: what bodies that deform have there, and what springs of other codes have.
struct Figure {
    std::string_view quantity;
    std::size_t index;  ///< of our pair: rebound psi_2, spin
    std::span<const Line> truth, springs;

    /// psi_2 = psi_1 + 1.4 spin: what is `psi2` in the one is that over 1.4 in the other.
    double scaled(double psi2) const { return index == 0 ? psi2 : psi2 / 1.4; }
};

constexpr double sliding = 5;          ///< psi_1 above which the whole impact slides [-]
constexpr double read_off = 0.15;      ///< psi_2 within which the figure is read there [-]
constexpr double mindlins_miss = 1.2;  ///< psi_2 that springs of Mindlin's stiffness are known to miss below [-]

/// Ours beside every line of what bodies that deform have.
void judge_lines(const Figure& figure, const char* grain, std::string_view source, const auto& ours,
                 CaseReport& report) {
    for (const Line& line : figure.truth) {
        const double miss = figure.scaled(line.x < sliding ? mindlins_miss : read_off);
        report.judge(
            {fmt::format("{}, psi_1 = {}: {} beside {}", grain, line.x, figure.quantity, source), "-", line.y, {}, {}},
            ours(line.x)[figure.index], line.y - miss, line.y + miss);
    }
}

/// The same, and ours no farther from finite elements than the springs of other codes; where all slides, as theirs.
void judge_figure(const Figure& figure, const char* grain, const auto& ours, CaseReport& report) {
    judge_lines(figure, grain, "finite elements", ours, report);
    std::vector<double> x, y;
    for (const Line& line : figure.truth) {
        x.push_back(line.x);
        y.push_back(line.y);
    }
    for (const Line& line : figure.springs) {
        const std::string name = fmt::format("{}, psi_1 = {}: {}", grain, line.x, figure.quantity);
        const double value = ours(line.x)[figure.index];
        if (line.x > sliding + 0.5) {
            const double miss = figure.scaled(read_off);
            report.judge({name + " beside the paper's springs", "-", line.y, {}, "sliding, as read off the figure"},
                         value, line.y - miss, line.y + miss);
        } else {
            const double elements = water::interpolated(x, y, line.x);
            const double miss = std::abs(line.y - elements) + 0.02;
            report.judge({name + ", no farther from finite elements than the paper's springs",
                          "-",
                          line.y,
                          {},
                          fmt::format("finite elements {:.4g}; 0.02 for the reading of the figure", elements)},
                         value, elements - miss, elements + miss);
        }
    }
}

}  // namespace

void normal_impact(const CaseSetting&, CaseReport& report) {
    for (const Grain& g : {Grain{"glass", 48e9, 0.20, 2800, 0.01}, Grain{"limestone", 20e9, 0.25, 2500, 0.01}}) {
        const double modulus = g.modulus / (2 * (1 - g.poisson_ratio * g.poisson_ratio));
        const std::string name = fmt::format("two spheres of {}", g.name);
        const Impact impact = two_spheres(g, 10);
        judge_hertz(name, impact, modulus, 0.5 * g.radius, 0.5 * g.mass(), 20, report);
        if (std::string_view(g.name) == "glass") {
            judge_curve(name, impact, chung_ooi::glass_curve, report);
        }
    }
    for (const Grain& g : {Grain{"aluminium", 70e9, 0.30, 2699, 0.1}, Grain{"magnesium", 40e9, 0.35, 1800, 0.1}}) {
        const double modulus = g.modulus / (1 - g.poisson_ratio * g.poisson_ratio);
        judge_hertz(fmt::format("{} on a plane", g.name), on_plane({g, 1, 0, {0, 0, -0.2}, {}, 200, true}), modulus,
                    g.radius, g.mass(), 0.2, report);
    }
    for (const Grain& g :
         {Grain{"aluminium oxide", 380e9, 0.23, 4000, 0.0025}, Grain{"cast iron", 100e9, 0.25, 7000, 0.0025}}) {
        for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
            const Impact impact = on_plane({g, e, 0, {0, 0, -3.9}, {}, 200, true});
            report.judge({fmt::format("{}, restitution {}", g.name, e), "-", {}, e, {}}, impact.velocity.z / 3.9,
                         Absolute{0.002});
            const Impact cut = on_plane({g, e, 0, {0, 0, -3.9}, {}, 200, false});
            report.judge({fmt::format("{}, restitution {}, force never pulls", g.name, e), "-", {}, e, {}},
                         cut.velocity.z / 3.9, Absolute{0.002});
        }
    }
}

void oblique_impact(const CaseSetting& setting, CaseReport& report) {
    // Gross sliding: the impulse across the normal is mu (1 + e) of that along it, whatever the stiffness.
    for (const auto& [mu, e, nu] :
         {std::array{0.1, 0.98, 0.25}, std::array{0.25, 0.6, 0.3}, std::array{0.4, 0.9, 0.1}}) {
        const Grain g{"grain", 1e13, nu, 2500, 0.01};
        const double angle = 80 * M_PI / 180, speed = 4;
        PlaneThrow t{g, e, mu, {speed * std::sin(angle), 0, -speed * std::cos(angle)}, {}, 1000, false};
        const Impact impact = on_plane(t);
        report.judge({fmt::format("sliding impact, mu = {}, e = {}, nu = {}: tangential restitution", mu, e, nu),
                      "-",
                      {},
                      1 - mu * (1 + e) / std::tan(angle),
                      {}},
                     impact.velocity.x / t.velocity.x, Relative{1e-3});
        report.judge({fmt::format("sliding impact, mu = {}, e = {}, nu = {}: spin", mu, e, nu),
                      "rad/s",
                      {},
                      2.5 * mu * (1 + e) * speed * std::cos(angle) / g.radius,
                      {}},
                     impact.spin.y, Relative{1e-3});
    }
    // Constant normal speed, varying tangential speed [ChungOoi2011, test 5]; psi_1 = v_s/(mu v_n).
    Plot plot;
    plot.title = "Rebound of a sphere from a plane";
    plot.x.label = "incident surface speed over mu v_n [-]";
    plot.y.label = "rebound surface speed over mu v_n [-]";
    for (const Grain& g : {Grain{"steel", 208e9, 0.3, 7850, 1e-5}, Grain{"polyethylene", 1e9, 0.4, 1400, 1e-5}}) {
        const auto rebound = [&](double psi1) {
            const double mu = 0.3, vn = 5;
            const Impact impact = on_plane({g, 1, mu, {psi1 * mu * vn, 0, -vn}, {}, 400, true});
            return std::array{(impact.velocity.x - g.radius * impact.spin.y) / (mu * vn),
                              -g.radius * impact.spin.y / (mu * vn)};
        };
        Curve ours{g.name, {}, {}, CurveStyle::markers, -1};
        for (double psi1 = 0.25; psi1 <= 8; psi1 += 0.25) {
            ours.x.push_back(psi1);
            ours.y.push_back(rebound(psi1)[0]);
        }
        plot.curves.push_back(ours);
        // The arm of the friction is the radius less the overlap, whose mean over the impulse of an elastic impact is
        // B(1.4, 0.5)/2 = 0.8176 of the largest: spin -5 (1 - 0.8176 delta_max/R), psi_2 = psi_1 - 2 + spin.
        const double depth =
            contact::hertz_largest_overlap(g.modulus / (1 - g.poisson_ratio * g.poisson_ratio), g.radius, g.mass(), 5);
        const double spin = -5 * (1 - 0.8176 * depth / g.radius);
        const std::string note = "-5 and psi_1 - 7 of rigid theory with the arm that a soft sphere has";
        for (const double psi1 : {7.0, 10.0, 20.0}) {
            const auto out = rebound(psi1);
            report.judge({fmt::format("{}, psi_1 = {}: rebound psi_2", g.name, psi1), "-", {}, psi1 - 2 + spin, note},
                         out[0], Absolute{0.001 * psi1});
            report.judge({fmt::format("{}, psi_1 = {}: spin", g.name, psi1), "-", {}, spin, note}, out[1],
                         Relative{0.001});
        }
        const bool is_steel = std::string_view(g.name) == "steel";
        judge_figure({"rebound psi_2", 0, chung_ooi::elements_rebound,
                      is_steel ? std::span<const Line>(chung_ooi::steel_rebound) : chung_ooi::polyethylene_rebound},
                     g.name, rebound, report);
        judge_figure({"spin", 1, chung_ooi::elements_spin,
                      is_steel ? std::span<const Line>(chung_ooi::steel_spin) : chung_ooi::polyethylene_spin},
                     g.name, rebound, report);
        if (is_steel) {
            judge_lines({"spin", 1, chung_ooi::theory_spin, {}}, "steel", "Thornton's theory", rebound, report);
        }
    }
    write_plot(setting, "oblique_impact", plot);

    // A spinning sphere: I w + m R v_t about the contact is kept, whatever the law.
    const Grain g{"grain", 1e13, 0.3, 2500, 0.01};
    const Impact impact = on_plane({g, 0.9, 0.3, {0, 0, -1}, {0, 400, 0}, 1000, false});
    report.judge({"spinning sphere slides: speed", "m/s", {}, 0.3 * 1.9, {}}, impact.velocity.x, Relative{1e-3});
    report.judge({"spinning sphere slides: spin", "rad/s", {}, 400 - 2.5 * 0.3 * 1.9 / 0.01, {}}, impact.spin.y,
                 Relative{1e-3});
}

}  // namespace riprap::validation::mellado
