// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "riprap/view/water_stream.hpp"

namespace riprap::view {

/// Gives the particles of frame `i`; no particles where the frame has none or could not be read.
using WaterSource = std::function<WaterFrame(std::size_t)>;

/// Fewest frames of a group, of any number of particles.
inline constexpr std::size_t fewest_group_frames = 4;

/// Water of a whole run, packed.
struct PackedWater {
    WaterScale scale;
    Vec3 low, high;  ///< box that holds the water but for the 0.2 % outermost on each side [m]
    std::size_t group_frames{frames_per_group};  ///< frames of a group: fewer where there are many particles
    std::vector<std::string> groups;
    std::size_t most_particles{0};  ///< in a frame, as stored
    std::size_t stride{1};          ///< every so many-th particle was kept
    std::size_t not_numbers{0};     ///< pressures and speeds that are not finite: stored as the lower bound
    double error() const { return scale.step / 2; }  ///< bound per coordinate [m]
    std::size_t bytes() const;
};

/// Packs `frame_count` frames within `budget` bytes. The step begins at 1/32 of `spacing` and is doubled until the
/// water fits; beyond 1/2 of the spacing every second particle is left out instead.
PackedWater pack_water(const WaterSource& source, std::size_t frame_count, double spacing, std::size_t budget);

}  // namespace riprap::view
