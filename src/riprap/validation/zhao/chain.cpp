// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/zhao/chain.hpp"

#include <cmath>
#include <vector>

namespace riprap::validation::zhao {

namespace {

/// Displacements, then velocities, of projectile and blocks.
using Phase = std::vector<double>;

Phase rate_of(const CubeChain& chain, const Phase& phase) {
    const std::size_t n = phase.size() / 2;
    Phase rate(phase.size(), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        rate[i] = phase[n + i];
    }
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const double d = phase[i] - phase[i + 1];
        if (d <= 0) {
            continue;  // no tension
        }
        const double u = chain.has_edge_effect ? d / chain.edge : 0;
        const double force = chain.stiffness * d * (1 - 2 * u + 4.0 / 3.0 * u * u);
        rate[n + i] -= force / chain.mass;
        rate[n + i + 1] += force / chain.mass;
    }
    return rate;
}

Phase moved(const Phase& phase, const Phase& rate, double dt) {
    Phase out = phase;
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] += dt * rate[i];
    }
    return out;
}

}  // namespace

ChainAnswer solve_chain(const CubeChain& chain) {
    const auto n = static_cast<std::size_t>(chain.count) + 1;
    Phase phase(2 * n, 0.0);
    phase[n] = chain.speed;
    const double dt = 1e-4 * std::sqrt(chain.mass / chain.stiffness);
    double time = 0;
    bool has_touched = false;
    while (true) {
        const Phase k1 = rate_of(chain, phase), k2 = rate_of(chain, moved(phase, k1, 0.5 * dt));
        const Phase k3 = rate_of(chain, moved(phase, k2, 0.5 * dt)), k4 = rate_of(chain, moved(phase, k3, dt));
        const double before = phase[n - 2] - phase[n - 1];
        for (std::size_t i = 0; i < phase.size(); ++i) {
            phase[i] += dt / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        }
        time += dt;
        const double overlap = phase[n - 2] - phase[n - 1];
        // The tail of the wave is a precursor of size round-off at first: wait for a real push.
        has_touched = has_touched || overlap > 1e-3 * chain.speed * std::sqrt(chain.mass / chain.stiffness);
        if (has_touched && overlap <= 0) {
            return {time - dt * overlap / (overlap - before), phase[2 * n - 1]};
        }
    }
}

}  // namespace riprap::validation::zhao
