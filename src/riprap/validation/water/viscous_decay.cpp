// SPDX-License-Identifier: Apache-2.0
// Laminar viscosity against exact solutions: vortices and a wave that die.
#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double pi = std::numbers::pi;

/// n of exp(n t) of a wave of number k on deep viscous water, from Lamb's relation [Lamb1932, art. 349]
///
///     (n + 2 nu k^2)^2 + g k tanh(k h) = 4 nu^2 k^4 sqrt(1 + n/(nu k^2)),
///
/// by the secant rule from its first order, i sigma - 2 nu k^2 [1/s]. tanh(k h) is 0.996 here.
std::complex<double> lamb_exponent(double k, double depth, double viscosity) {
    const double sigma2 = 9.81 * k * std::tanh(k * depth), a = viscosity * k * k;
    const auto residual = [&](std::complex<double> n) {
        return (n + 2 * a) * (n + 2 * a) + sigma2 - 4 * a * a * std::sqrt(1.0 + n / a);
    };
    std::complex<double> before{-2 * a, std::sqrt(sigma2)}, now = before * 1.01;
    for (int i = 0; i < 60 && std::abs(now - before) > 1e-14; ++i) {
        const std::complex<double> f0 = residual(before), f1 = residual(now);
        const std::complex<double> next = now - f1 * (now - before) / (f1 - f0);
        before = now;
        now = next;
    }
    return now;
}

/// Amplitude of the mode cos(kx) of the surface of water from x = 0 to `length` and y = 0 to `depth` [m].
double mode_amplitude(const WaterTrial& trial, double k, double length, double depth) {
    const fluid::ParticleState& water = trial.state().fluid;
    double sum = 0;
    for (std::size_t i = 0; i < water.position.size(); ++i) {
        const Vec3& x = water.position[i];
        sum += trial.sph().particle_mass / water.density[i] * std::cosh(k * x.y) * std::cos(k * x.x);
    }
    // eta = a cos(kx) adds a cosh(kh) L/2 to the integral of cosh(ky) cos(kx); waves have no part beneath by Green.
    return 2 * sum / (length * std::cosh(k * depth));
}

}  // namespace

void taylor_green(const CaseSetting& setting, CaseReport& report) {
    constexpr double viscosity = 0.01, rate = 8 * pi * pi * viscosity;  // of the speed [1/s]; L = U = 1
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.01"};
    }
    WaterTrial trial(setting, finer);
    // A perfect lattice stretches along the stagnation lines without a gradient of concentration that shifting could
    // act on, until it tears: places are a tenth of a spacing off. Density starts with the pressure of the flow.
    sim::State& start = trial.initial();
    std::mt19937 random(1);
    const auto jitter = [&] {
        return 0.2 * trial.sph().spacing * (static_cast<double>(random()) / 4294967296.0 - 0.5);
    };
    for (std::size_t i = 0; i < start.fluid.position.size(); ++i) {
        start.fluid.position[i] += Vec3{jitter(), jitter(), 0};
        const double x = 2 * pi * start.fluid.position[i].x, y = 2 * pi * start.fluid.position[i].y;
        start.fluid.velocity[i] = {-std::cos(x) * std::sin(y), std::sin(x) * std::cos(y), 0};
        start.fluid.density[i] = fluid::density_of(trial.sph(), -0.25 * 1000 * (std::cos(2 * x) + std::cos(2 * y)));
    }
    trial.run();
    const std::vector<double>& energy = trial.column("fluid.kinetic");
    const auto speed = [&](double t) { return std::sqrt(interpolated(trial.time(), energy, t) / (0.25 * 1000)); };
    report.judge({"rms speed at 1 s over the first", "-", {}, std::exp(-rate), "exp(-8 pi^2 t/Re)"}, speed(1),
                 Relative{0.03});
    report.judge({"rms speed at 2 s over the first", "-", {}, std::exp(-2 * rate), "likewise"}, speed(2),
                 Relative{0.03});
    report.judge({"rate of decay from 0.2 to 2 s", "1/s", {}, rate, "8 pi^2/Re"}, std::log(speed(0.2) / speed(2)) / 1.8,
                 Relative{0.03});
}

void viscous_wave(const CaseSetting& setting, CaseReport& report) {
    constexpr double length = 2, depth = 1, viscosity = 0.01, k = 2 * pi / length, amplitude = 0.02;
    const std::complex<double> n = lamb_exponent(k, depth, viscosity);
    const double omega = std::sqrt(9.81 * k * std::tanh(k * depth));
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.01"};
    }
    WaterTrial trial(setting, finer);
    sim::State& start = trial.initial();
    for (std::size_t i = 0; i < start.fluid.position.size(); ++i) {
        const Vec3& x = start.fluid.position[i];
        const double speed = amplitude * omega / std::sinh(k * depth);
        start.fluid.velocity[i] = {-speed * std::sin(k * x.x) * std::cosh(k * x.y),
                                   speed * std::cos(k * x.x) * std::sinh(k * x.y), 0};
    }
    std::vector<double> mode;
    trial.run([&](const WaterTrial& now) { mode.push_back(mode_amplitude(now, k, length, depth)); });
    std::vector<double> squared;
    for (const double a : mode) {
        squared.push_back(a * a);
    }
    const double period = 2 * pi / n.imag();
    const double first = integral(trial.time(), squared, 0, period);
    const double second = integral(trial.time(), squared, period, 2 * period);
    report.judge({"rate at which its energy decays", "1/s", {}, -2 * n.real(), "Lamb; 4 nu k^2 to first order"},
                 std::log(first / second) / period, Relative{0.1});
    const std::vector<double> zeros = crossings(trial.time(), mode, 0);
    report.judge(
        {"period", "s", {}, period, "Lamb"},
        zeros.size() > 2 ? 2 * (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1) : std::nan(""),
        Relative{5e-3});
    judge_ledger(report, trial);
}

}  // namespace riprap::validation::water
