// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/solid/affine/block_contacts.hpp"

namespace riprap::solid::explicit_dda {

/// Returns for every contact point the inverse of the mass that it bears of its pair, whose blocks move as rigid ones
/// [1/kg]: sum_j k_j G_ij/k_i over the points of the pair that overlap, G_ij the acceleration of gap i by a unit force
/// at j. The corners of a face that lands flat share the mass of the block; a block that lands on one corner gives way
/// by turning. At least what the whole masses of both blocks give. Empty where no surface is damped.
std::vector<double> pair_mobility(const affine::BlockSystem& system, const affine::BlockState& state,
                                  const std::vector<affine::BlockContact>& contacts);

}  // namespace riprap::solid::explicit_dda
