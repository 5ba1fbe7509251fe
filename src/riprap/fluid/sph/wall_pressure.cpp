// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/wall_pressure.hpp"

#include <algorithm>

#include "riprap/core/parallel.hpp"

namespace riprap::fluid {

void extrapolate_to_walls(const WaterAtWallSums& water, const Vec3& gravity, BoundaryParticles& walls,
                          WallFields& seen) {
    seen.mirrored_velocity.resize(walls.position.size());
    seen.grip.resize(walls.position.size());
    walls.pressure.resize(walls.position.size());
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double weight = water.weight[w];
        const bool is_wet = weight > 0;
        const double head = dot(gravity - walls.acceleration[w], water.moment[w]);
        walls.pressure[w] = is_wet ? std::max(0.0, (water.pressure[w] + head) / weight) : 0;
        if (!walls.given_pressure.empty() && walls.given_pressure[w] >= 0) {
            walls.pressure[w] = walls.given_pressure[w];
        }
        seen.mirrored_velocity[w] = is_wet ? 2.0 * walls.velocity[w] - water.velocity[w] / weight : walls.velocity[w];
        seen.grip[w] = walls.is_slippery[w] != 0 ? 0 : 1;
    });
}

}  // namespace riprap::fluid
