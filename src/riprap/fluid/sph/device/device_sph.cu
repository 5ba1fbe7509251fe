// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/device/device_sph.hpp"

#include "riprap/core/parallel_device.hpp"
#include "riprap/fluid/sph/delta_sph.hpp"
#include "riprap/fluid/sph/device/water_copy.hpp"

namespace riprap::fluid {

bool has_device() { return parallel::device::device_count() > 0; }
std::string device_name() { return parallel::device::device_name(); }

std::unique_ptr<ParticleScheme> make_device_scheme(const SphSettings& settings) {
    if (has_device()) {
        return std::make_unique<DeltaSph<WaterCopy<parallel::device::Device>>>(settings);
    }
    return make_device_scheme_on_host(settings);
}

}  // namespace riprap::fluid
