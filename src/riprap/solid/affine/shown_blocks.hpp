// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/core/shown.hpp"
#include "riprap/solid/affine/blocks.hpp"

namespace riprap::solid::affine {

/// Fields that blocks with uniform strain show: the six components of the Cauchy stress sigma, tension positive, von
/// Mises' stress sqrt(3/2 s : s) with s = sigma - tr(sigma)/3 I, and the six components of the strain (F F^T - I)/2,
/// which is the small strain where that is small; world axes.
std::span<const ShownField> shown_of_blocks();

/// Returns field number `field` of a block.
double show_block(const BlockState& blocks, std::size_t block, std::size_t field);

}  // namespace riprap::solid::affine
