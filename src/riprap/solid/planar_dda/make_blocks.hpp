// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/solid/planar_dda/model.hpp"
#include "riprap/solid/planar_dda/state.hpp"
#include "riprap/solid/solid_scene.hpp"

// Blocks of a planar scene: one for each body, in the same order.

namespace riprap::solid::planar_dda {

/// Blocks of a scene: a function of Model alone.
struct SceneBlocks {
    Model model;
    State state;         ///< as the bodies stand at the start
    double smallest{0};  ///< side of a square as large as the smallest block that is no half-space [m]
    std::vector<SceneProblem> problems;
};

/// A disc in the plane.
struct Disc {
    Vec2 center{};
    double radius{1};
};
/// Returns a disc that holds all bodies but half-spaces.
Disc disc_around(const SolidScene& scene, const body::BodyState& bodies);

/// Makes a block of every body: its outline, material and joints. A half-space becomes a rectangle a hundred times as
/// large as `around`, the disc about the bodies at the start. Stiffnesses are per metre across the plane. Apart from
/// `state` the blocks depend on the Model and `around` alone. Problems are outlines that are no polygon, and
/// stiffnesses of contacts that are not positive or exceed 1e6 times Young's modulus.
SceneBlocks make_blocks(const SolidScene& scene, const body::BodyState& bodies, const Disc& around,
                        const affine::Elasticity& elasticity, PlaneState plane);

}  // namespace riprap::solid::planar_dda
