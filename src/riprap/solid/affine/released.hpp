// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/core/step.hpp"
#include "riprap/solid/affine/blocks.hpp"
#include "riprap/solid/explicit_dem.hpp"

namespace riprap::solid::affine {

/// A block that loads move from a span on, as it was at the beginning of the span.
struct ReleasedBlock {
    std::int32_t block;
    Vec3 position, velocity;
    Mat3 gradient;  ///< of the velocity [1/s]
};

/// Finds the blocks that a span releases: free in this span, held in the span before, which was `previous_dt` long.
std::vector<ReleasedBlock> released_blocks(const body::BodySet& bodies, const TimeSpan& span, double previous_dt,
                                           const BlockState& blocks);

/// Books energy and momentum of a released block at the beginning of the span, for a method whose energies are those at
/// the end of the step.
void book_released(const BlockSystem& system, const BlockState& blocks, const ReleasedBlock& released,
                   KickReport& kick);

/// Books energy and momentum of a released block after the step, for a method whose energies are those at mid-step:
/// half of the first kick came without a path to do work along.
void book_released_at_middle(const BlockSystem& system, const BlockState& blocks, double dt,
                             const ReleasedBlock& released, KickReport& kick);

}  // namespace riprap::solid::affine
