// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/wall_pressure.hpp"

#include <algorithm>

#include "riprap/core/parallel.hpp"

namespace riprap::fluid {

void extrapolate_to_walls(const SphSettings& settings, const WaterAtWallSums& water, const Vec3& gravity,
                          BoundaryParticles& walls, WallFields& seen) {
    mirror_velocity(settings, water, walls, seen);
    walls.pressure.resize(walls.position.size());
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double weight = water.weight[w];
        const bool is_wet = weight > 0;
        const double head = dot(gravity - walls.acceleration[w], water.moment.vector(w));
        walls.pressure[w] = is_wet ? std::max(0.0, (water.pressure[w] + head) / weight) : 0;
        if (!walls.given_pressure.empty() && walls.given_pressure[w] >= 0) {
            walls.pressure[w] = walls.given_pressure[w];
        }
    });
}

void mirror_velocity(const SphSettings& settings, const WaterAtWallSums& water, const BoundaryParticles& walls,
                     WallFields& seen) {
    seen.mirrored_velocity.resize(walls.position.size(), settings.is_plain);
    seen.grip.resize(walls.position.size(), settings.is_plain);
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double weight = water.weight[w];
        const Vec3& v = walls.velocity[w];
        seen.mirrored_velocity.set_vector(w, weight > 0 ? 2.0 * v - water.velocity.vector(w) / weight : v);
        seen.grip.set(w, walls.is_slippery[w] != 0 ? 0 : 1);
    });
}

}  // namespace riprap::fluid
