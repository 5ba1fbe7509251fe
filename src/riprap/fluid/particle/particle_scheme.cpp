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

void book_walls(const BoundaryParticles& walls, double dt, FluidReport& report) {
    struct Push {
        Vec3 force{};
        double power{0}, slip{0};
    };
    const std::span<const Vec3> at_face = walls.at_face();
    const auto one = [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const Vec3 force = walls.pressure_force[w] + walls.viscous_force[w];
        const Vec3 faster = at_face[w] - walls.velocity[w];  // than the particle that schemes see the heat at
        return Push{force, dot(force, walls.velocity[w]), dot(walls.viscous_force[w], faster)};
    };
    const Push push = parallel::reduce(walls.size(), Push{}, one, [](const Push& a, const Push& b) {
        return Push{a.force + b.force, a.power + b.power, a.slip + b.slip};
    });
    report.impulse -= dt * push.force;
    report.work_on_solids = dt * (push.power + push.slip);
    report.dissipated_viscous -= dt * push.slip;
}

}  // namespace riprap::fluid
