// SPDX-License-Identifier: Apache-2.0
// Free oscillation of water in a tank.
#include <fmt/format.h>

#include <cmath>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double gravity = 9.81, length = 1.0, depth = 0.5, amplitude = 0.01;

/// Potential flow of the first mode, eta = a cos(kx) sin(omega t), when the surface is flat.
void set_velocities(sim::State& state, double k, double omega) {
    for (std::size_t i = 0; i < state.fluid.position.size(); ++i) {
        const Vec3& x = state.fluid.position[i];
        const double speed = amplitude * omega / std::sinh(k * depth);
        state.fluid.velocity[i] = {-speed * std::sin(k * x.x) * std::cosh(k * x.y),
                                   speed * std::cos(k * x.x) * std::sinh(k * x.y), 0};
    }
}

/// Amplitude of the first mode: the integral of y cos(kx) over the water is h a L/2 for small a [m].
double mode_amplitude(const WaterTrial& trial, double k) {
    const fluid::ParticleState& water = trial.state().fluid;
    double sum = 0;
    for (std::size_t i = 0; i < water.position.size(); ++i) {
        sum += trial.sph().particle_mass / water.density[i] * water.position[i].y * std::cos(k * water.position[i].x);
    }
    return 2 * sum / (depth * length);
}

}  // namespace

void standing_wave(const CaseSetting& setting, CaseReport& report) {
    const double k = M_PI / length, omega = std::sqrt(gravity * k * std::tanh(k * depth)), period = 2 * M_PI / omega;
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.01"};
    }
    WaterTrial trial(setting, finer);
    set_velocities(trial.initial(), k, omega);
    std::vector<double> measured;
    trial.run([&](const WaterTrial& now) { measured.push_back(mode_amplitude(now, k)); });
    const std::vector<double> zeros = crossings(trial.time(), measured, 0);
    const auto halves = static_cast<double>(zeros.size() - 1);
    report.judge({"period", "s", {}, period, "omega^2 = g k tanh kh"},
                 zeros.size() > 1 ? 2 * (zeros.back() - zeros.front()) / halves : std::nan(""), Relative{5e-3});
    // Crests by the square of the mode: its integral over a period is a^2 T/2, which falls as exp(-2 d t).
    std::vector<double> squared;
    for (const double a : measured) {
        squared.push_back(a * a);
    }
    const double first = integral(trial.time(), squared, 0, period);
    const double third = integral(trial.time(), squared, 2 * period, 3 * period);
    const double rate = -std::log(third / first) / (2 * period);  // of energy
    // Artificial viscosity alpha acts like nu = alpha h c/8 in the plane [Monaghan2005].
    const double nu = trial.sph().viscosity.get<fluid::ArtificialViscosity>().alpha * trial.sph().smoothing_length() *
                      trial.sph().sound_speed / 8;
    report.state({"rate at which its energy decays", "1/s",
                  fmt::format("4 nu k^2 = {:.3g} with the nu = alpha h c/8 of the artificial viscosity: theory knows "
                              "nothing of the other losses, so there is no band",
                              4 * nu * k * k)},
                 rate);
    Plot plot{"Standing wave, first mode", "", {"time [s]", false}, {"amplitude of the mode [m]", false}, {}, false};
    std::vector<double> exact;
    for (const double t : trial.time()) {
        exact.push_back(amplitude * std::sin(omega * t));
    }
    plot.curves = {{"linear theory, no viscosity", trial.time(), exact, CurveStyle::line, 0},
                   {"ours", trial.time(), measured, CurveStyle::markers, 0}};
    write_plot(setting, "standing_wave", plot);
}

}  // namespace riprap::validation::water
