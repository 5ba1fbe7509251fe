// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/contact/broadphase/broadphase.hpp"

namespace riprap::contact {

/// The candidate pairs by testing every part against every other: the definition that faster searches must meet.
/// Ordinary parts make a pair when their bounding spheres are closer than `skin`; a giant and another part when no
/// face plane of the giant keeps the other's bounding sphere farther than `skin`. Costs n(n-1)/2 tests.
///
/// @param skin  s >= 0 [m]
/// @returns pairs a < b, sorted, without parts of one body and without pairs of two immobile parts
std::vector<PartPair> find_pairs_brute_force(const PartBounds& bounds, std::span<const Giant> giants, double skin);

}  // namespace riprap::contact
