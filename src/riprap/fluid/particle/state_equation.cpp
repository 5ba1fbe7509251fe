// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/state_equation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/fluid/particle/linear_law.hpp"

namespace riprap::fluid {
namespace {

bool is_linear(const ParticleSettings& s) { return s.state_equation != StateEquation::tait; }

/// Density below which nothing is stored and nothing pulls
double least_density(const ParticleSettings& s) {
    return s.state_equation == StateEquation::linear_without_tension ? s.rest_density : 0;
}

}  // namespace

double pressure_of(const ParticleSettings& s, double density) { return PressureLaw(s)(density); }

double density_of(const ParticleSettings& s, double pressure) {
    const double strain = pressure / (s.rest_density * s.sound_speed * s.sound_speed);
    if (is_linear(s)) {
        return s.rest_density * std::max(0.0, 1 + strain);
    }
    return s.rest_density * std::pow(std::max(0.0, 1 + s.tait_exponent * strain), 1 / s.tait_exponent);
}

double internal_energy_of(const ParticleSettings& s, double actual_density) {
    const double density = std::max(actual_density, least_density(s));
    const double x = density / s.rest_density, c2 = s.sound_speed * s.sound_speed;
    const double n = s.tait_exponent - 1;
    if (is_linear(s) || n == 0) {
        return c2 * (std::log(x) + 1 / x - 1);
    }
    return c2 / s.tait_exponent * ((power(x, n) - 1) / n + 1 / x - 1);
}

double sound_speed_of(const ParticleSettings& s, double density) {
    if (is_linear(s)) {
        return s.sound_speed;
    }
    return s.sound_speed * std::pow(density / s.rest_density, (s.tait_exponent - 1) / 2);
}

SoundSpeed choose_sound_speed(double gravity, double depth, double max_speed) {
    const double wave = std::sqrt(gravity * depth);
    const char* const which = wave >= max_speed ? "sqrt(g depth)" : "the fastest motion";
    const double value = 10 * std::max(wave, max_speed);
    return {value, fmt::format("c_0 = 10 x {} = {:.4g} m/s (depth {:.4g} m, fastest motion {:.4g} m/s)", which, value,
                               depth, max_speed)};
}

}  // namespace riprap::fluid
