// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/fluid/sph/sph_scratch.hpp"

// What both schemes do with the forces they found.

namespace riprap::fluid {

/// v += dt (force + extra force)/m + dt g, and everything of the report that belongs to particles. Needs scratch.force
/// [N], heat [W] and wall_hold.
void kick(const ParticleSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
          const SphScratchData& scratch, std::span<const Vec3> extra_force, FluidReport& report);

/// Impulse and work between fluid and walls, from the forces on wall particles.
void book_walls(const BoundaryParticles& walls, double dt, FluidReport& report);

/// The first particle that is not finite or out of the domain goes into the report, if any.
void find_lost_particle(const ParticleSettings& settings, const ParticleState& state, double time, FluidReport& report);

/// The first particle that is not finite or faster than sound likewise.
void find_wild_particle(const ParticleSettings& settings, const ParticleState& state, double time, FluidReport& report);

}  // namespace riprap::fluid
