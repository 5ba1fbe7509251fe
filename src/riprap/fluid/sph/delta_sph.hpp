// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/fluid/sph/sph_step.hpp"

// The verbs of sph_step.hpp for one scheme each.

namespace riprap::fluid::delta_sph {

/// Continuity with density diffusion [Antuono2010], [Fourtakas2019].
void update_density(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, double dt, SphScratchData& scratch, FluidReport& report);

/// Pressure, viscosity, walls by extrapolated pressure [Adami2012], shifting.
void accelerate(const SphSettings& settings, ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                double dt, SphScratchData& scratch, FluidReport& report, std::span<const Vec3> extra_force);

}  // namespace riprap::fluid::delta_sph
