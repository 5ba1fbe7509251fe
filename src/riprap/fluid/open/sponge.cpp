// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/open/sponge.hpp"

#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"

namespace riprap::fluid {

namespace {

/// r s^2 at x, 0 outside [1/s].
double rate_at(const Sponge& sponge, const Vec3& x, int dimension) {
    for (int axis = 0; axis < dimension; ++axis) {
        if (!(x[axis] >= sponge.low[axis] && x[axis] <= sponge.high[axis])) {
            return 0;
        }
    }
    const double length = sponge.high[sponge.axis] - sponge.low[sponge.axis];
    const double way =
        sponge.is_towards_high ? x[sponge.axis] - sponge.low[sponge.axis] : sponge.high[sponge.axis] - x[sponge.axis];
    return sponge.rate * (way / length) * (way / length);
}

}  // namespace

double sponge_rate(double gravity, double depth, double length) {
    return 3 * std::log(100.0) * std::sqrt(gravity * depth) / length;
}

void push_sponges(std::span<const Sponge> sponges, const ParticleSettings& settings, const ParticleState& state,
                  double dt, SparseVectors& force, SpongeWork& work) {
    const auto count = state.position.size();
    work.force.reset(count);
    work.before.reset(count);
    const auto push = [&](std::size_t i) {
        double rate = 0;  // of all together: their shares could sum to more than the velocity
        Vec3 pull{};
        for (const Sponge& sponge : sponges) {
            const double one = rate_at(sponge, state.position[i], settings.domain.dimension);
            rate += one;
            pull += one * (state.velocity[i] - sponge.velocity);
        }
        if (rate > 0) {
            const Vec3 sum = (settings.particle_mass * std::expm1(-rate * dt) / (rate * dt)) * pull;
            force.add(i, sum);
            work.force.add(i, sum);
            work.before.add(i, state.velocity[i]);
        }
    };
    parallel::for_ranges(state.size(), 16 * SparseVectors::block_size, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            push(static_cast<std::size_t>(i));
        }
    });
}

double absorbed_energy(const ParticleState& state, double dt, const SpongeWork& work) {
    const auto one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        return -0.5 * dot(work.force[i], work.before[i] + state.velocity[i]);
    };
    return dt * parallel::sum(state.blocks(), one);
}

}  // namespace riprap::fluid
