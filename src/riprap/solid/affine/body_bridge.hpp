// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/core/step.hpp"
#include "riprap/solid/affine/block_contacts.hpp"
#include "riprap/solid/affine/released.hpp"
#include "riprap/solid/solid_scene.hpp"

// Between the bodies of a scene and the blocks of a DDA: one body, one block, in the same order.

namespace riprap::solid::affine {

/// Says that bodies deform, none of them stretched so far; leaves bodies alone that already do. Loads have a pull then.
void start_stretching(body::BodyState& bodies);

/// Poses, velocities and stretches of the bodies as x = x_c + F X, F = R U.
void read_bodies(const body::BodyState& bodies, const body::BodySet& set, BlockState& blocks);

/// Scratch of a method of blocks in space: the blocks of its scene, and the loads of a piece.
struct SceneBlocks {
    BlockSystem system;
    std::string problem;  ///< what blocks cannot be made of
    std::vector<Mat3> pull;
    body::Loads loads;  ///< of contacts, in the last piece
    body::PointLoadSum point_loads;
};

/// Makes the blocks of a scene where the Scratch is fresh, and their State with its bonds where that is.
void begin(const SolidScene& scene, const Elasticity& elasticity, body::BodyState& bodies, BlockState& blocks,
           BlockContactHistory& contacts, SceneBlocks& scratch);

/// What a piece of a step begins with.
struct Piece {
    body::LoadView given;  ///< with the point loads of the scene
    BlockLoads loads;      ///< the same, for blocks
    std::vector<ReleasedBlock> released;
};

/// Sums the loads of a piece, sets gravity and what is driven, and finds the blocks that are released.
Piece begin_piece(const SolidScene& scene, const TimeSpan& span, const body::LoadView& given, double previous_dt,
                  body::BodyState& bodies, BlockState& blocks, SceneBlocks& scratch);

/// Says which blocks loads move now, and gives the others the velocity that takes them to their place at span.end().
/// @param bodies  rates of the corrections of absorbing paddles
void drive_blocks(const SolidScene& scene, const TimeSpan& span, const body::BodyState& bodies, BlockSystem& system,
                  BlockState& blocks);

/// Writes poses, velocities, angular momenta, stretches U (body axes) and rates of stretching D (world axes) of F = R
/// U.
void write_bodies(const BlockSystem& system, const BlockState& blocks, body::BodyState& bodies);

}  // namespace riprap::solid::affine
