// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/second_order_wave.hpp"

#include <cmath>
#include <string>

namespace riprap::wave {

double SecondOrderWave::elevation(double phase) const {
    const double k = first.wave_number, kd = first.kd(), h = first.height;
    const double second = k * h * h / 16 * std::cosh(kd) * (2 + std::cosh(2 * kd)) / std::pow(std::sinh(kd), 3);
    return 0.5 * h * std::cos(phase) + second * std::cos(2 * phase);
}

WaveVelocity SecondOrderWave::velocity(double phase, double above_bed) const {
    const double kz = first.wave_number * above_bed, sinh_kd = std::sinh(first.kd());
    const double one = 0.5 * first.angular_frequency * first.height / sinh_kd;
    const double two =
        3.0 / 16 * first.angular_frequency * first.wave_number * first.height * first.height / std::pow(sinh_kd, 4);
    return {one * std::cosh(kz) * std::cos(phase) + two * std::cosh(2 * kz) * std::cos(2 * phase),
            one * std::sinh(kz) * std::sin(phase) + two * std::sinh(2 * kz) * std::sin(2 * phase)};
}

SecondOrderWave second_order_wave(double height, double period, double depth, double gravity) {
    const LinearWave first = linear_wave(height, period, depth, gravity);
    const double ursell = height * first.length() * first.length() / (depth * depth * depth);
    const double most = 8 * M_PI * M_PI / 3;
    if (ursell >= most) {
        throw NoSuchWave("a wave of H L^2/d^3 = " + std::to_string(ursell) +
                         " to the second order, which is good below " + std::to_string(most) + ": heights up to " +
                         std::to_string(height * most / ursell) + " m");
    }
    const double steepest = 0.142 * first.length() * std::tanh(first.kd());
    if (height > steepest) {
        throw NoSuchWave("a wave " + std::to_string(height) + " m high breaks; at this length " +
                         std::to_string(steepest) + " m at most");
    }
    return {first};
}

}  // namespace riprap::wave
