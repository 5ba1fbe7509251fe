// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/particle_scheme.hpp"

namespace riprap::fluid {

/// Reports the first particle that is not finite or out of the domain, if any.
void find_lost_particle(const ParticleSettings& settings, const ParticleState& state, double time,
                        ParticleReport& report);

/// Reports the first particle that is not finite or faster than sound, if any.
void find_wild_particle(const ParticleSettings& settings, const ParticleState& state, double time,
                        ParticleReport& report);

}  // namespace riprap::fluid
