// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/sph/kick_loops.hpp"
#include "riprap/fluid/sph/sph_scratch.hpp"

// Forces become velocities and books, the same in both schemes.

namespace riprap::fluid {

/// Books what a kick added up.
void book_kick(const ParticleSettings& settings, std::int64_t count, const Vec3& gravity, double dt,
               const KickSums& sums, FluidReport& report);

/// Kicks the fluid, v += dt (V force + extra force)/m + dt g, where its columns are; all but the internal energy is
/// booked.
/// @param found        volumes and the sums of forces
/// @param extra_force  of every particle by its number, as a functor may hold it [N]
template <class Where, class Extra>
void kick_particles(const ParticleSettings& settings, const ParticleColumns& water, const Vec3& gravity, double dt,
                    SphNumbers<Where>& found, const Extra& extra_force, FluidReport& report) {
    ForceSumsIn<Where>& forces = found.forces;
    const KickParticle<Extra> kick_one{settings.particle_mass,
                                       dt,
                                       gravity,
                                       without_periodic(gravity, settings.domain),
                                       water,
                                       found.water.volume.columns(),
                                       forces.pushes.columns(),
                                       forces.heat.columns(),
                                       forces.wall_heat.columns(),
                                       forces.wall_hold.columns(),
                                       forces.wall_hold_power.columns(),
                                       extra_force};
    book_kick(settings, water.count, gravity, dt, Where::reduce(water.count, KickSums{}, kick_one, AddKickSums{}),
              report);
}

/// Books the energy of compression at the densities that the forces saw.
void book_compression(const ParticleSettings& settings, const ParticleState& state, FluidReport& report);

/// The whole kick of particles on the host.
void kick(const ParticleSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
          SphNumbers<parallel::Host>& found, const SparseVectors& extra_force, FluidReport& report);

/// Books impulse and work between fluid and walls from the forces on wall particles.
void book_walls(const BoundaryParticles& walls, double dt, FluidReport& report);

/// Reports the first particle that is not finite or out of the domain, if any.
void find_lost_particle(const ParticleSettings& settings, const ParticleState& state, double time, FluidReport& report);

/// Reports the first particle that is not finite or faster than sound, if any.
void find_wild_particle(const ParticleSettings& settings, const ParticleState& state, double time, FluidReport& report);

}  // namespace riprap::fluid
