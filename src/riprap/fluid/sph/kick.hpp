// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/fluid/sph/sph_scratch.hpp"

// Forces become velocities and books, the same in both schemes.

namespace riprap::fluid {

/// Kicks the fluid, v += dt (V force + extra force)/m + dt g, and reports what belongs to particles.
/// @param volume  V of every particle [m^3]
/// @param found   force per volume [N/m^3] with its heats
void kick(const ParticleSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
          const Numbers<1>& volume, const ForceSums& found, const SparseVectors& extra_force, FluidReport& report);

/// Books impulse and work between fluid and walls from the forces on wall particles.
void book_walls(const BoundaryParticles& walls, double dt, FluidReport& report);

/// Reports the first particle that is not finite or out of the domain, if any.
void find_lost_particle(const ParticleSettings& settings, const ParticleState& state, double time, FluidReport& report);

/// Reports the first particle that is not finite or faster than sound, if any.
void find_wild_particle(const ParticleSettings& settings, const ParticleState& state, double time, FluidReport& report);

}  // namespace riprap::fluid
