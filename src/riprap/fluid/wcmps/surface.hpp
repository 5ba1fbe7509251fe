// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/wcmps/wcmps_scratch.hpp"

// Classes of particles about the free surface, and what they decide: collisions and shifting.

namespace riprap::fluid::wcmps {

/// Class of every particle and normals of class B.
void classify(const WcmpsSettings& settings, const ParticleState& state, WcmpsScratchData& scratch);

/// Changes of velocity that make pairs of classes F and B that approach below the collision distance part
/// [Mellado2021, eqs. 5.38, 5.39], in scratch.collisions.change; returns whether there are any.
bool find_collisions(const WcmpsSettings& settings, const ParticleState& state, WcmpsScratchData& scratch);

/// Longest shift and energy of place that its first half took away.
struct Shifting {
    double potential{0};        ///< [J]
    double longest_squared{0};  ///< [m^2]
};

/// Moves particles down the gradient of concentration [Mellado2021, eq. 5.36]:
///
///     delta x = -F grad C,   F = 2 l_0 dt u,   at most a tenth of l_0,
///
/// and F at most 0.5/MpsLattice::wave_stiffness, which halves the stiffest wave of lattice planes in a step and ends
/// one of pairs at 0.8 l_0, which are twice as stiff: more would turn it over. u is how fast neighbours pass each
/// other, where the source takes the fastest particle of all, see docs/theory/wcmps.md, 6. The first half is made at
/// once, the second after the next update of density. Class B and F along the surface only, E not.
Shifting shift(const WcmpsSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
               const WcmpsScratchData& scratch);

}  // namespace riprap::fluid::wcmps
