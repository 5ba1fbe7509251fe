// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/core/step.hpp"
#include "riprap/solid/affine/body_bridge.hpp"
#include "riprap/solid/planar_dda/model.hpp"
#include "riprap/solid/planar_dda/state.hpp"

// Between the bodies of a planar scene and the blocks of planar DDA: one body, one block, in the same order.

namespace riprap::solid::planar_dda {

/// Blocks of a scene: a function of Model alone.
struct SceneBlocks {
    Model model;
    State state;               ///< as the bodies stand at the start
    std::vector<Vec2> offset;  ///< of the centroid from the origin of the body, body frame [m]
    double smallest{0};        ///< side of a square as large as the smallest block that is no half-space [m]
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
/// `state` the blocks depend on the Model and `around` alone.
void make_blocks(const SolidScene& scene, const body::BodyState& bodies, const Disc& around,
                 const affine::Elasticity& elasticity, PlaneState plane, SceneBlocks& blocks);

/// Says which blocks loads move over the span, and how far the others go in it.
void drive_blocks(const SolidScene& scene, const TimeSpan& span, const body::BodyState& bodies, const State& state,
                  SceneBlocks& blocks, std::vector<Unknowns>& driven);

/// Gathers force, torque and pull of given loads.
void read_loads(const body::LoadView& loads, std::vector<Unknowns>& sums);

/// Writes poses, velocities, angular momenta, stretches U (body axes) and rates of stretching D (world axes).
void write_bodies(const SceneBlocks& blocks, const State& state, body::BodyState& bodies);

}  // namespace riprap::solid::planar_dda
