// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/fluid/mps/mps_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"

namespace riprap::fluid::mps {

/// Lets the places at which particles stand have the density of the pressure with which they begin, alpha_c p/gamma
/// above n_0: ParticleState::dilution holds by how much the count of neighbours falls short of that [-]. A lattice has
/// n_0 at any depth, and without it water falls, and what stands in it, until it is squeezed to what carries its
/// pressure. With `divergence_share` = 0 the density is that of the count alone, as in the source.
/// @param first  the smallest id of those that begin
void begin_with_pressure(const MpsSettings& settings, std::int64_t first, ParticleState& state);

}  // namespace riprap::fluid::mps
