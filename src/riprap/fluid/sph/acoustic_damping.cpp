// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/acoustic_damping.hpp"

#include <algorithm>

namespace riprap::fluid {

double strength_of_damping(const SphSettings& settings) {
    return settings.gradient_correction ? settings.acoustic_damping : 0;
}

double even_share(double lopsidedness) {
    // Inside waves that break 999 of 1000 particles have less than 0.2; first rows behind flat surfaces have 0.56 and
    // more from h/dp = 1.2 on, crowded ones more.
    constexpr double even = 0.2, lopsided = 0.4;
    return std::clamp((lopsided - lopsidedness) / (lopsided - even), 0.0, 1.0);
}

double resistance_of_damping(const SphSettings& settings) {
    return strength_of_damping(settings) * settings.smoothing_length() * settings.rest_density * settings.sound_speed;
}

}  // namespace riprap::fluid
