// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::wave {

/// A progressive wave of small amplitude over a flat bed [Dean1991, ch. 3].
struct LinearWave {
    double height;             ///< H, crest to trough [m]
    double depth;              ///< d of still water [m]
    double gravity;            ///< g [m/s^2]
    double angular_frequency;  ///< omega = 2 pi / T [rad/s]
    double wave_number;        ///< k = 2 pi / L [rad/m]

    double length() const;          ///< L [m]
    double celerity() const;        ///< c = omega / k [m/s]
    double group_velocity() const;  ///< c_g = c/2 (1 + 2 k d / sinh 2 k d) [m/s]
    double kd() const { return wave_number * depth; }
};

/// Solves the dispersion relation omega^2 = g k tanh(k d) for k [rad/m] to a few units in the last place.
/// @param angular_frequency  > 0 [rad/s]
/// @param depth  > 0 [m]
/// @param gravity  > 0 [m/s^2]
double wave_number(double angular_frequency, double depth, double gravity);

/// The wave of given height and period [s].
LinearWave linear_wave(double height, double period, double depth, double gravity);

}  // namespace riprap::wave
