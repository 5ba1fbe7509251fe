// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/boussinesq_wave.hpp"

#include <cmath>

namespace riprap::wave {

WaveVelocity boussinesq_velocity(const SolitaryWave& wave, double from_crest, double above_bed) {
    const double d = wave.depth, k = wave.shape_number(), y = above_bed;
    const double s = 1 / std::cosh(k * from_crest), t = std::tanh(k * from_crest), s2 = s * s;
    const double eta = wave.height * s2, first = -2 * wave.height * k * s2 * t;
    const double second = wave.height * k * k * (4 * s2 * t * t - 2 * s2 * s2);
    const double third = wave.height * k * k * k * (16 * s2 * s2 * t - 8 * s2 * t * t * t);
    const double speed = std::sqrt(wave.gravity * d);
    return {speed / d * (eta - eta * eta / (4 * d) + d * d / 3 * (1 - 1.5 * y * y / (d * d)) * second),
            -speed * y / d * ((1 - eta / (2 * d)) * first + d * d / 3 * (1 - 0.5 * y * y / (d * d)) * third)};
}

}  // namespace riprap::wave
