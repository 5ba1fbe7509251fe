// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/particle_scheme.hpp"

#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"

namespace riprap::fluid {

namespace {

/// Force on walls, its power, and that of what the face is faster than the particle that schemes see [N], [W].
struct Push {
    Vec3 force{};
    double power{0}, slip{0};

    template <class By>
    static void join(Push& a, const Push& b, const By& by) {
        by.add(a.force, b.force);
        by.add(a.power, b.power);
        by.add(a.slip, b.slip);
    }
};

}  // namespace

void drift(const ParticleSettings& settings, ParticleState& state, double dt) {
    const Domain& domain = settings.domain;
    parallel::for_each(state.blocks(), [&](std::int64_t entry) {
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
    const std::span<const Vec3> at_face = walls.at_face();
    const auto one = [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const Vec3 force = walls.pressure_force[w] + walls.viscous_force[w];
        const Vec3 faster = at_face[w] - walls.velocity[w];  // than the particle that schemes see the heat at
        return Push{force, dot(force, walls.velocity[w]), dot(walls.viscous_force[w], faster)};
    };
    const Push push = parallel::sum(walls.size(), one);
    report.impulse -= dt * push.force;
    report.work_on_solids = dt * (push.power + push.slip);
    report.dissipated_viscous -= dt * push.slip;
}

}  // namespace riprap::fluid
