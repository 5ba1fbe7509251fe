// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "riprap/body/ground.hpp"
#include "riprap/coupling/particle_walls/near_parts.hpp"
#include "riprap/fluid/particle/sweep/periodic_images.hpp"

namespace riprap::coupling {

/// Position of a part, or of ground, relative to a particle.
struct Touch {
    Vec3 place;       ///< of the particle's image [m]
    Vec3 normal;      ///< n
    double distance;  ///< of the nearest face, negative inside [m]
    double reach;     ///< of the push [m]
    std::int32_t body;
    bool is_ground;
};

/// Finds the deepest of the images of a particle in a part, if it is nearer than `within`.
std::optional<Touch> deepest_touch(const PlacedPart& part, const Vec3& x, double within,
                                   const fluid::PeriodicImages& images);

/// Finds the same of ground: of its surface as one, so that no edge between two triangles is felt.
std::optional<Touch> touch_ground(const body::Ground& ground, const Pose& pose, const Vec3& x, double within,
                                  const fluid::PeriodicImages& images);

}  // namespace riprap::coupling
