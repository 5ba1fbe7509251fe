// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/fluid/sph/sph_step.hpp"

namespace riprap::fluid {

/// The verbs of sph_step.hpp as one scheme does them; gravity lies in the plane of a planar scene.
struct Scheme {
    /// nullptr where density is summed with the forces
    void (*update_density)(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                           const Vec3& gravity, double dt, SphScratchData& scratch, FluidReport& report);
    void (*begin_forces)(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                         SphScratchData& scratch);
    void (*load_walls)(const SphSettings& settings, const ParticleState& state, BoundaryParticles& walls,
                       const Vec3& gravity, SphScratchData& scratch);
    void (*kick_fluid)(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                       const Vec3& gravity, double dt, SphScratchData& scratch, FluidReport& report,
                       const SparseVectors& extra_force);
};

/// Continuity with density diffusion [Antuono2010], [Fourtakas2019]; pressure, viscosity, walls by extrapolated
/// pressure [Adami2012], shifting.
extern const Scheme delta_sph_scheme;

/// Density summed over neighbours, p = c_0^2 (rho - rho_0) where positive, forces with the spiky kernel [Muller2003] as
/// corrected in docs/theory/sph.md, 9. With the drifts before and after, it is the symplectic Euler step of the source.
/// Density and forces come from different kernels, so no energy belongs to the forces: the ledger's residual is theirs.
extern const Scheme muller_scheme;

}  // namespace riprap::fluid
