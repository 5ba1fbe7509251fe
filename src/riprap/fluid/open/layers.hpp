// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "riprap/fluid/particle/particle_settings.hpp"

namespace riprap::fluid {

/// Layers behind an opening: as deep as a support wherever the first one is on its way.
inline std::int64_t layer_count(const ParticleSettings& settings) {
    return static_cast<std::int64_t>(std::ceil(settings.support_radius() / settings.spacing - 1e-9)) + 1;
}

}  // namespace riprap::fluid
