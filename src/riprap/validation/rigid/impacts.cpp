// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/settle.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81;

/// Restitution of a linear spring and dashpot that cannot pull, damping ratio xi < 1. Contact begins with speed 1 and
/// ends where the force vanishes, 2 xi v + x = 0 in units of omega: after the phase
/// tau = (pi - atan(2 xi s/(1 - 2 xi^2)))/s, s = sqrt(1 - xi^2), and e = exp(-xi tau).
double restitution(double xi) {
    const double s = std::sqrt(1 - xi * xi);
    return std::exp(-xi * (M_PI - std::atan2(2 * xi * s, 1 - 2 * xi * xi)) / s);
}

double damping_for(double e) {
    double low = 0, high = 0.999;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (restitution(middle) > e ? low : high) = middle;
    }
    return low;
}

/// A cube dropped face down from height 1 m above the ground. It stands for a ball: its moments of inertia are made a
/// million times larger, because a face-down bounce is unstable. A tilt comes out of the impact, half a period of the
/// spring, as a spin of 0.8 omega/sqrt(2) times itself, and the flight of 0.9 s makes 2000 tilts of it.
Trial dropped_cube(double xi) {
    SceneBuilder scene;
    scene.add_material({.name = "rock", .density = 2500, .normal_stiffness = 1e9, .damping_ratio = xi});
    BodySpec ground;
    ground.name = "ground";
    ground.shape = scene.add_half_space({0, 0, 1}, 0);
    ground.drive = body::Drive::fixed;
    scene.add_body(ground);
    BodySpec cube;
    cube.name = "cube";
    cube.shape = scene.add_shape(geometry::cube(0.2));
    cube.pose.position.z = 1.1;
    const BodyId body = scene.add_body(cube);
    scene.model.bodies.principal_moments[static_cast<std::size_t>(body.value)] *= 1e6;
    scene.model.gravity.value = {0, 0, -gravity};
    return Trial(std::move(scene));
}

struct Bounces {
    std::vector<double> peaks;       ///< [m] above the ground, of the lower face
    double rest_time{std::nan("")};  ///< [s]
    double highest_energy{0};        ///< of the moments without contact, over the energy at the start [-]
    double lowest_energy{1};         ///< likewise
    double phase{0};                 ///< omega dt of the contact [-]
    std::vector<double> time, height;
};

Bounces bounce_until(double xi, std::size_t count, double end) {
    Trial trial = dropped_cube(xi);
    const BodyId cube{1};
    Bounces bounces;
    const double stiffness = 1e9 * 0.04 / 0.1, mass = 2500 * 0.008;  // k_n S/r: the ground has no field
    bounces.phase = std::sqrt(stiffness / mass) * trial.dt();
    const double ground = mass * gravity * 0.1, energy = mass * gravity * 1.0;
    double previous_speed = 0;
    trial.run_until(end, [&](const Trial& now) {
        const double height = now.position(cube).z - 0.1, speed = now.velocity(cube).z;
        if (previous_speed > 0 && speed <= 0 && height > 0 && bounces.peaks.size() < count) {
            bounces.peaks.push_back(height);
        }
        if (height > 1e-5 || std::abs(speed) > 0.015) {  // 0.4 % of the time is left then
            bounces.rest_time = now.time();              // the last moment of noticeable motion
        }
        if (now.report().contact_count == 0) {
            const double share = (now.report().ledger.kinetic + now.report().ledger.potential - ground) / energy;
            bounces.highest_energy = std::max(bounces.highest_energy, share);
            bounces.lowest_energy = std::min(bounces.lowest_energy, share);
        }
        previous_speed = speed;
        bounces.time.push_back(now.time());
        bounces.height.push_back(height);
    });
    return bounces;
}

}  // namespace

void bounce(const CaseSetting& setting, CaseReport& report) {
    Plot plot;
    plot.title = "A cube dropped face down from 1 m";
    plot.subtitle = "contact damping gives restitution e; peaks e^(2n) h";
    plot.x.label = "time [s]";
    plot.y.label = "height of the lower face [m]";
    for (const double e : {0.5, 0.8}) {
        const double rest = std::sqrt(2 / gravity) * (1 + e) / (1 - e);
        const Bounces bounces = bounce_until(damping_for(e), 3, 1.3 * rest);
        // The dashpot sets in at once. When it first acts the step has carried the cube up to v dt deep, so that up to
        // xi omega dt of the speed is lost or saved by chance at every impact.
        const double chance = damping_for(e) * bounces.phase / e;
        const std::string reason = fmt::format(
            "the step meets the ground at a chance phase: up to xi omega dt/e = {:.2g} of e per impact", chance);
        for (std::size_t n = 0; n < 3; ++n) {
            const double impacts = static_cast<double>(n + 1), exact = std::pow(e, 2 * impacts);
            const double spread = 2 * impacts * chance;
            report.judge({fmt::format("e = {}, peak {}", e, n + 1), "m", {}, exact, {}},
                         n < bounces.peaks.size() ? bounces.peaks[n] : std::nan(""), 0.99 * exact, 1.01 * exact,
                         CloseBand{exact * (1 - spread), exact * (1 + spread), reason});
        }
        report.judge({fmt::format("e = {}, comes to rest at", e), "s", {}, rest, {}}, bounces.rest_time, 0.98 * rest,
                     1.02 * rest, CloseBand{rest * (1 - 2 * chance), rest * (1 + 2 * chance), reason});
        plot.curves.push_back({fmt::format("e = {}", e), bounces.time, bounces.height, CurveStyle::line, -1});
    }
    write_plot(setting, "bounce", plot);
    const std::size_t count = setting.is_full ? 100 : 20;
    const double between = 2 * std::sqrt(2 / gravity);
    const Bounces elastic = bounce_until(0, count, (static_cast<double>(count) + 1) * between);
    // Leapfrog enters a spring with an energy off by omega^2 x (v dt - x)/2, x the depth where it first acts: up to
    // (omega dt)^2/4 of the energy, lost on entering and won on leaving, at chance phases.
    const double chance = 0.25 * elastic.phase * elastic.phase;
    const double spread = chance * std::sqrt(2.0 * static_cast<double>(count));
    const std::string reason = fmt::format("chance phase of the steps: (omega dt)^2/4 = {:.2g} per impact", chance);
    report.judge(
        {fmt::format("e = 1, highest energy in {} bounces over the first", count), "-", {}, 1.0, {}, Kind::bookkeeping},
        elastic.highest_energy, 0.9999, 1.0001, CloseBand{0.9999, 1 + spread, reason});
    report.judge(
        {fmt::format("e = 1, lowest energy in {} bounces over the first", count), "-", {}, 1.0, {}, Kind::bookkeeping},
        elastic.lowest_energy, 0.9999, 1.0001, CloseBand{1 - spread, 1.0001, reason});
}

}  // namespace riprap::validation::rigid
