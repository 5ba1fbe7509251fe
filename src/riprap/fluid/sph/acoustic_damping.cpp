// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/acoustic_damping.hpp"

namespace riprap::fluid {

double strength_of_damping(const SphSettings& settings) {
    return settings.gradient_correction ? settings.acoustic_damping : 0;
}

double resistance_of_damping(const SphSettings& settings) {
    return strength_of_damping(settings) * settings.smoothing_length() * settings.rest_density * settings.sound_speed;
}

}  // namespace riprap::fluid
