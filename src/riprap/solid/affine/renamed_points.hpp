// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "riprap/solid/affine/block_contacts.hpp"

namespace riprap::solid::affine {

/// Gives contact points of a pair that are named anew the rows of the history that their old names left over. A point
/// where corner and edges of two blocks lie on each other is called by the corner of either or by the crossing,
/// whichever round-off and strain prefer; its shear spring stays the same. A name is the heir of one that shares a
/// corner of a block with it; each row has one heir.
/// @param own   points of the pair, those of rows that were found again with `old` set
/// @param begin, end  rows of the pair
void carry_renamed(const BlockContactHistory& history, std::size_t begin, std::size_t end, std::span<BlockContact> own);

}  // namespace riprap::solid::affine
