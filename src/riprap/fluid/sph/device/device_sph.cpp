// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/device/device_sph.hpp"

#include "riprap/fluid/sph/delta_sph.hpp"
#include "riprap/fluid/sph/device/water_copy.hpp"

namespace riprap::fluid {

std::unique_ptr<ParticleScheme> make_device_scheme_on_host(const SphSettings& settings) {
    return std::make_unique<DeltaSph<WaterCopy<parallel::Host>>>(settings);
}

#ifndef RIPRAP_WITH_CUDA  // else in device_sph.cu
std::unique_ptr<ParticleScheme> make_device_scheme(const SphSettings& settings) {
    return make_device_scheme_on_host(settings);
}
bool has_device() { return false; }
std::string device_name() { return "none"; }
#endif

}  // namespace riprap::fluid
