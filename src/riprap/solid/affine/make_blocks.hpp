// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/solid/affine/blocks.hpp"
#include "riprap/solid/solid_scene.hpp"

// Blocks of a scene: one for each body, in the same order.

namespace riprap::solid::affine {

/// Radius of the smallest body that may move and is no half-space; 0 = none [m].
double smallest_radius(const SolidScene& scene);

/// Area that a contact point stands for at least where stiffness goes by area: a hundredth of the square of the
/// smallest radius. Corners and edges touch without an area, and would sink in otherwise [m^2].
double least_contact_area(const SolidScene& scene);

/// Stiffness of a contact of two corners [N/m].
double corner_stiffness(const SolidScene& scene, const Elasticity& elasticity);

/// Stiffness of a fixed point: its own, or a hundred times that of a contact where it has none [N/m].
inline double stiffness_of(const body::FixedPoint& point, double of_contact) {
    return point.stiffness > 0 ? point.stiffness : 100 * of_contact;
}

/// Returns the bodies that no block can be made of: those of several parts that are no ground.
std::vector<SceneProblem> scene_problems(const SolidScene& scene);

/// Blocks for the bodies of a scene: shapes in the axes and masses of the bodies, pair properties.
/// @returns what a block cannot be made of: a body of several parts; empty = done
std::string make_blocks(const SolidScene& scene, const Elasticity& elasticity, BlockSystem& system);

}  // namespace riprap::solid::affine
