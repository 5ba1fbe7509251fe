// SPDX-License-Identifier: Apache-2.0
#pragma once

// Books of a step that the methods of deformable blocks have in common.

#include "riprap/body/motion.hpp"
#include "riprap/solid/affine/blocks.hpp"
#include "riprap/solid/solid_scene.hpp"

namespace riprap::solid::affine {

/// Takes mass, energies and momenta of the blocks into a report.
void book_sums(const BlockSums& sums, KickReport& kick);

/// Adds impulses of gravity, given loads and supports in a piece of length `dt`, work of what is driven, the moment of
/// mass and the fastest block.
/// @param since  that positions are ahead of the kick, by the velocities: 0 where it is at the end of the piece [s]
void book_outside(const BlockSystem& system, const BlockState& blocks, const body::LoadView& given,
                  const body::Loads& contacts, double dt, double since, KickReport& kick);

}  // namespace riprap::solid::affine
