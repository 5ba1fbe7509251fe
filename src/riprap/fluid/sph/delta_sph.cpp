// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/delta_sph.hpp"

#include "riprap/fluid/sph/device/device_sph.hpp"
#include "riprap/fluid/sph/muller.hpp"
#include "riprap/fluid/sph/two_clocks.hpp"

namespace riprap::fluid {

template class DeltaSph<WaterInPlace>;

std::unique_ptr<ParticleScheme> make_scheme(const SphSettings& settings) {
    if (settings.scheme == SphScheme::muller) {
        return std::make_unique<Muller>(settings);
    }
    if (settings.sound_steps > 1 && !settings.is_on_device()) {
        return std::make_unique<TwoClocks>(settings);
    }
    return settings.is_on_device() ? make_device_scheme(settings) : std::make_unique<DeltaSph<WaterInPlace>>(settings);
}

}  // namespace riprap::fluid
