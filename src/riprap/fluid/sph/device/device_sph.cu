// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/parallel_cuda.hpp"
#include "riprap/fluid/sph/device/device_scheme.hpp"

namespace riprap::fluid {

std::unique_ptr<ParticleScheme> make_device_scheme(const SphSettings& settings) {
    if (parallel::cuda::device_count() == 0) {
        return make_device_scheme_on_host(settings);
    }
    return std::make_unique<DeviceSph<parallel::cuda::Device>>(settings);
}

std::string device_name() { return parallel::cuda::device_count() == 0 ? "none" : parallel::cuda::device_name(); }

}  // namespace riprap::fluid
