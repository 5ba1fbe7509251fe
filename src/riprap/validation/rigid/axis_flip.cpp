// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation::rigid {

namespace {

SceneBuilder one_body(const Vec3& size, const Vec3& velocity, const Vec3& spin) {
    SceneBuilder scene;
    scene.add_material({.name = "rock", .density = 2500, .normal_stiffness = 1e8});
    BodySpec body;
    body.name = "block";
    body.shape = scene.add_shape(geometry::box(size));
    body.velocity = velocity;
    body.angular_velocity = spin;
    scene.add_body(body);
    return scene;
}

/// A body with given principal moments, without gravity, starting with `spin`.
Trial free_rotor(const Vec3& moments, const Vec3& spin) {
    SceneBuilder scene = one_body({1, 1, 1}, {}, {});
    // No box has moments 1 : 2 : 3, so they are given directly.
    scene.model.bodies.principal_moments[0] = moments;
    scene.model.bodies.principal_axes[0] = Quat{};
    scene.state.bodies.angular_momentum[0] = {moments.x * spin.x, moments.y * spin.y, moments.z * spin.z};
    return Trial(std::move(scene));
}

/// Spin about the body's own second axis, and the energy.
double second_spin(const Trial& trial) {
    return rotate_back(trial.orientation(BodyId{0}), trial.angular_velocity(BodyId{0})).y;
}
double rotation_energy(const Trial& trial) {
    return 0.5 * dot(trial.state().bodies.angular_momentum[0], trial.angular_velocity(BodyId{0}));
}

struct Flips {
    std::vector<double> crossings;
    double energy_drift{0};
};

Flips flip(const Vec3& spin, double end) {
    Trial trial = free_rotor({1, 2, 3}, spin);
    trial.set_dt(1e-3);
    const double energy = rotation_energy(trial);
    Flips flips;
    double previous = second_spin(trial);
    trial.run_until(end, [&](const Trial& now) {
        const double present = second_spin(now);
        if (previous * present < 0) {
            flips.crossings.push_back(now.time() - now.dt() * present / (present - previous));
        }
        previous = present;
        flips.energy_drift = std::max(flips.energy_drift, std::abs(rotation_energy(now) / energy - 1));
    });
    return flips;
}

}  // namespace

void axis_flip(const CaseSetting& setting, CaseReport& report) {
    // Jacobi's solution for moments 1, 2, 3: omega_2 vanishes at first_, then every half period.
    const double half = 16.597498;
    const Flips slow = flip({0.01, 1, 0.02}, setting.is_full ? 200.5 * half : 20.5 * half);
    report.judge({"first time omega_2 = 0", "s", {}, 8.81336, {}}, slow.crossings.at(0), Absolute{1e-4});
    const auto last = slow.crossings.size() - 1;
    report.judge({"half period, mean", "s", {}, half, {}},
                 (slow.crossings.at(last) - slow.crossings.at(0)) / static_cast<double>(last), Absolute{1e-4});
    report.judge_below({"change of energy", "-", {}, {}, {}, Kind::bookkeeping}, slow.energy_drift, 1e-6);
    const Flips fast = flip({0.1, 1, 0.1}, 40);
    report.judge({"larger disturbance, first time omega_2 = 0", "s", {}, 6.885703, {}}, fast.crossings.at(0),
                 Absolute{1e-4});
    report.judge({"larger disturbance, half period", "s", {}, 11.498131, {}},
                 fast.crossings.at(1) - fast.crossings.at(0), Absolute{1e-4});
}

}  // namespace riprap::validation::rigid
