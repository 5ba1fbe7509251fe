// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"

namespace riprap::solid::sphere_dem {

/// Places spheres, parts and triangles where their bodies are; velocities are those of `state` and
/// `scratch.kinematics`.
void place(const SphereModel& model, const body::BodyState& state, SphereScratch& scratch);

/// Number of things that spheres can meet besides spheres: polyhedral parts, then triangles.
inline std::int32_t wall_count(const SphereModel& model) { return model.bodies.part_count() + model.triangles.size(); }
/// Body of a wall.
inline std::int32_t wall_body(const SphereModel& model, std::int32_t wall) {
    const std::int32_t parts = model.bodies.part_count();
    return wall < parts ? model.bodies.parts[static_cast<std::size_t>(wall)].body.value
                        : model.triangles.body[static_cast<std::size_t>(wall - parts)];
}

/// Is the wall a part of a body that meets others by its spheres?
inline bool stands_for_spheres(const SphereModel& model, std::int32_t wall) {
    return wall < model.bodies.part_count() && model.spheres.count_of(wall_body(model, wall)) > 0;
}

}  // namespace riprap::solid::sphere_dem
