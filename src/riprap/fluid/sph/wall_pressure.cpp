// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/wall_pressure.hpp"

#include <algorithm>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/sph/pair_sums.hpp"
#include "riprap/fluid/sph/wall_averages.hpp"

namespace riprap::fluid {

void average_at_walls(const SphSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                      SphScratchData& scratch) {
    const auto count = walls.position.size();
    make_zero(scratch.wall_weight, count);
    make_zero(scratch.wall_pressure, count);
    make_zero(scratch.wall_moment, count);
    make_zero(scratch.wall_velocity, count);
    const WallAverages pair{WendlandC2(settings.smoothing_length(), settings.domain.dimension)};
    std::vector<Vec3>&moment = scratch.wall_moment, &velocity = scratch.wall_velocity;
    add_pair_sums(settings, pair, {walls.position, {}},
                  {state.position,
                   {component(state.velocity, 0), component(state.velocity, 1), component(state.velocity, 2),
                    field(scratch.pressure), field(state.density)}},
                  {sink(scratch.wall_weight), sink(scratch.wall_pressure), sink_component(moment, 0),
                   sink_component(moment, 1), sink_component(moment, 2), sink_component(velocity, 0),
                   sink_component(velocity, 1), sink_component(velocity, 2)},
                  scratch.walls_fluid);
}

void extrapolate_to_walls(BoundaryParticles& walls, const Vec3& gravity, SphScratchData& scratch) {
    scratch.mirrored_velocity.resize(walls.position.size());
    scratch.grip.resize(walls.position.size());
    walls.pressure.resize(walls.position.size());
    const std::vector<Vec3>&moment = scratch.wall_moment, &velocity = scratch.wall_velocity;
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double weight = scratch.wall_weight[w];
        const bool is_wet = weight > 0;
        const double head = dot(gravity - walls.acceleration[w], moment[w]);
        walls.pressure[w] = is_wet ? std::max(0.0, (scratch.wall_pressure[w] + head) / weight) : 0;
        if (!walls.given_pressure.empty() && walls.given_pressure[w] >= 0) {
            walls.pressure[w] = walls.given_pressure[w];
        }
        scratch.mirrored_velocity[w] = is_wet ? 2.0 * walls.velocity[w] - velocity[w] / weight : walls.velocity[w];
        scratch.grip[w] = walls.is_slippery[w] != 0 ? 0 : 1;
    });
}

}  // namespace riprap::fluid
