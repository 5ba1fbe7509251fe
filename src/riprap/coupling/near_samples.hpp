// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/rigid_map.hpp"
#include "riprap/coupling/sample_set.hpp"
#include "riprap/fluid/particle/domain.hpp"

namespace riprap::coupling {

/// Numbers of the samples that water may feel, in rising order: all those of bodies that can move, and of those that
/// never do the ones that some particle comes within `reach` of. Some farther ones are among them, none is left out.
/// Most walls stand dry most of the time, and a dry sample adds nothing to any sum.
///
/// The water is entered into cells of half a reach; a sample is near where one of the cells up to two away holds water,
/// over periodic sides too.
/// @param is_still  per body: never moves
/// @param water     places of all particles, in any order; those that are not finite are passed over
/// @param others    of whatever else wants samples near it
/// @param reach     [m]
std::vector<std::int32_t> near_samples(const SampleSet& samples, const body::Motion& motion,
                                       std::span<const std::uint8_t> is_still, std::span<const Vec3> water,
                                       std::span<const Vec3> others, const fluid::Domain& domain, double reach);

}  // namespace riprap::coupling
