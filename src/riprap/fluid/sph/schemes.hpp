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
void begin_forces(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                  SphScratchData& scratch);
void load_walls(const SphSettings& settings, const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                SphScratchData& scratch);
void kick_fluid(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                double dt, SphScratchData& scratch, FluidReport& report, std::span<const Vec3> extra_force);

}  // namespace riprap::fluid::delta_sph

namespace riprap::fluid::muller {

/// Density summed over neighbours, p = c_0^2 (rho - rho_0) where positive, forces with the spiky kernel [Muller2003] as
/// corrected in docs/theory/sph.md, 9. With the drifts before and after, it is the symplectic Euler step of the source.
/// Density and forces come from different kernels, so no energy belongs to the forces: the ledger's residual is theirs.
void begin_forces(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                  SphScratchData& scratch);
void load_walls(const SphSettings& settings, const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                SphScratchData& scratch);
void kick_fluid(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                double dt, SphScratchData& scratch, FluidReport& report, std::span<const Vec3> extra_force);

}  // namespace riprap::fluid::muller
