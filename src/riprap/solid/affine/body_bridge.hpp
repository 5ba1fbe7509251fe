// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/core/step.hpp"
#include "riprap/solid/affine/blocks.hpp"
#include "riprap/solid/affine/elasticity.hpp"
#include "riprap/solid/solid_scene.hpp"

// Between the bodies of a scene and the blocks of a DDA: one body, one block, in the same order.

namespace riprap::solid::affine {

/// Radius of the smallest body that may move and is no half-space; 0 = none [m].
double smallest_radius(const SolidScene& scene);

/// Area that a contact point stands for at least where stiffness goes by area: a hundredth of the square of the
/// smallest radius. Corners and edges touch without an area, and would sink in otherwise [m^2].
double least_contact_area(const SolidScene& scene);

/// Stiffness of a contact of two corners [N/m].
double corner_stiffness(const SolidScene& scene, const Elasticity& elasticity);

/// Returns the bodies that no block can be made of: those of several parts that are no ground.
std::vector<SceneProblem> scene_problems(const SolidScene& scene);

/// Blocks for the bodies of a scene: shapes in the axes and masses of the bodies, pair properties.
/// @returns what a block cannot be made of: a body of several parts; empty = done
std::string make_blocks(const SolidScene& scene, const Elasticity& elasticity, BlockSystem& system);

/// Says that bodies deform, none of them stretched so far; leaves bodies alone that already do. Loads have a pull then.
void start_stretching(body::BodyState& bodies);

/// Poses, velocities and stretches of the bodies as x = x_c + F X, F = R U.
void read_bodies(const body::BodyState& bodies, const body::BodySet& set, BlockState& blocks);

/// Says which blocks loads move now, and gives the others the velocity that takes them to their place at span.end().
/// @param bodies  rates of the corrections of absorbing paddles
void drive_blocks(const SolidScene& scene, const TimeSpan& span, const body::BodyState& bodies, BlockSystem& system,
                  BlockState& blocks);

/// Writes poses, velocities, angular momenta, stretches U (body axes) and rates of stretching D (world axes) of F = R
/// U.
void write_bodies(const BlockSystem& system, const BlockState& blocks, body::BodyState& bodies);

}  // namespace riprap::solid::affine
