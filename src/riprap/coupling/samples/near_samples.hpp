// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"

namespace riprap::coupling {

/// Numbers of the samples that water may feel, in rising order: all those of bodies that can move, but for bodies that
/// are told to be far, and of those that never do the ones that some particle comes within `reach` of. Some farther
/// ones are among them, none is left out: fours of samples stay together, as sums take them at once. Most walls stand
/// dry most of the time, and a dry sample adds nothing to any sum.
///
/// The water is entered into cells of half a reach; a sample is near where one of the cells up to two away holds water,
/// over periodic sides too.
/// @param is_still  per body: never moves
/// @param water     places of all particles, in any order; those that are not finite are passed over
/// @param others    of whatever else wants samples near it
/// @param reach     [m]
/// @param is_far    per body: of those that can move, which have none near; empty: none
std::vector<std::int32_t> near_samples(const SampleSet& samples, const body::Motion& motion,
                                       std::span<const std::uint8_t> is_still, std::span<const Vec3> water,
                                       std::span<const Vec3> others, const fluid::Domain& domain, double reach,
                                       std::span<const std::uint8_t> is_far = {});

/// Returns 1 for each of the bodies `asked` that has a sample within `reach` of water or others, and may do so for one
/// that has none within 1.5 times that; 0 for bodies that are not asked for.
std::vector<std::uint8_t> near_bodies(const SampleSet& samples, const body::Motion& motion,
                                      std::span<const std::uint8_t> asked, std::span<const Vec3> water,
                                      std::span<const Vec3> others, const fluid::Domain& domain, double reach);

}  // namespace riprap::coupling
