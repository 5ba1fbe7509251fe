// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"

namespace riprap::solid::sphere_dem {

/// Places spheres, parts and triangles where their bodies are; velocities are those of `state` and
/// `scratch.kinematics`.
void place(const SphereModel& model, const body::BodyState& state, SphereScratch& scratch);

/// Body of a wall.
inline std::int32_t wall_body(const SphereModel& model, std::int32_t wall) {
    const std::int32_t parts = model.bodies.part_count();
    return wall < parts ? model.bodies.parts[static_cast<std::size_t>(wall)].body.value
                        : model.triangles.body[static_cast<std::size_t>(wall - parts)];
}

}  // namespace riprap::solid::sphere_dem
