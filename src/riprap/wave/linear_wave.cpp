// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/linear_wave.hpp"

#include <cmath>
#include <numbers>

namespace riprap::wave {

double wave_number(double angular_frequency, double depth, double gravity) {
    // With x = k d and q = omega^2 d / g the relation is x tanh x = q. Its left side is convex up to x = 1.2 and nearly
    // straight beyond, and the start lies within 5 % of the root [Eckart1952], so Newton's steps close in at once.
    const double q = angular_frequency * angular_frequency * depth / gravity;
    double x = q / std::sqrt(std::tanh(q));
    for (int i = 0; i < 20; ++i) {
        const double t = std::tanh(x);
        const double step = (x * t - q) / (t + x * (1 - t * t));
        x -= step;
        if (std::abs(step) <= 4e-16 * x) {
            break;
        }
    }
    return x / depth;
}

LinearWave linear_wave(double height, double period, double depth, double gravity) {
    const double omega = 2 * std::numbers::pi / period;
    return {height, depth, gravity, omega, wave_number(omega, depth, gravity)};
}

double LinearWave::length() const { return 2 * std::numbers::pi / wave_number; }

double LinearWave::celerity() const { return angular_frequency / wave_number; }

double LinearWave::group_velocity() const {
    const double two_kd = 2 * kd();
    // In deep water sinh overflows long after its share has vanished.
    const double share = two_kd > 700 ? 0.0 : two_kd / std::sinh(two_kd);
    return 0.5 * celerity() * (1 + share);
}

}  // namespace riprap::wave
