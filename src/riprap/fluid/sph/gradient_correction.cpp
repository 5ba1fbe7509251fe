// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/gradient_correction.hpp"

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/sph/sph_scratch.hpp"

namespace riprap::fluid {

void leave_gradients(std::size_t particles, SphScratchData& scratch) {
    scratch.correction.resize(particles);
    parallel::for_each(static_cast<std::int64_t>(particles),
                       [&](std::int64_t i) { scratch.correction[static_cast<std::size_t>(i)] = unit_tensor; });
}

}  // namespace riprap::fluid
