// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"

namespace riprap::coupling {

/// Returns the slope of the solid at each of its samples i: sum_j V_j grad W_ij over the samples of the same solid,
/// which points into it and is near nothing deep inside [1/m]. In the frame of the body; bodies that never move count
/// as one solid, in world axes.
/// @param motion    where the bodies are, of which only those of still ones are looked at
/// @param is_still  per body: never moves
/// @param reach     of the kernel [m]
std::vector<Vec3> solid_slopes(const SampleSet& samples, const body::Motion& motion,
                               std::span<const std::uint8_t> is_still, const fluid::WendlandC2& kernel, double reach,
                               const fluid::Domain& domain);

}  // namespace riprap::coupling
