// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/particle_scheme.hpp"

#include <cmath>

#include "riprap/core/parallel.hpp"

namespace riprap::fluid {

void drift(const ParticleSettings& settings, ParticleState& state, double dt) {
    const Domain& domain = settings.domain;
    parallel::for_each(state.owned(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        Vec3& x = state.position[i];
        x += dt * state.velocity[i];
        for (int axis = 0; axis < domain.dimension; ++axis) {
            if (domain.is_periodic[static_cast<std::size_t>(axis)] &&
                (x[axis] < domain.low[axis] || x[axis] >= domain.high[axis])) {
                const double period = domain.high[axis] - domain.low[axis];
                x[axis] -= period * std::floor((x[axis] - domain.low[axis]) / period);
            }
        }
    });
}

}  // namespace riprap::fluid
