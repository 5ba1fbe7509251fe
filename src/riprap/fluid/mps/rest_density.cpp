// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/rest_density.hpp"

#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::fluid::mps {

void begin_with_pressure(const MpsSettings& settings, std::int64_t first, ParticleState& state) {
    if (!(settings.divergence_share > 0)) {
        return;
    }
    for (std::size_t i = 0; i < state.density.size(); ++i) {
        if (state.id[i] >= first) {
            state.dilution[i] +=
                settings.compressibility / settings.relaxation * pressure_of(settings, state.density[i]);
        }
    }
}

}  // namespace riprap::fluid::mps
