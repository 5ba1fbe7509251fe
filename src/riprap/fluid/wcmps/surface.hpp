// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/wcmps/wcmps_scratch.hpp"

// Classes of particles about the free surface, and what they decide: collisions and shifting.

namespace riprap::fluid::wcmps {

/// Class of every particle, normals of class B and numbers of approaching pairs.
void classify(const WcmpsSettings& settings, const ParticleState& state, WcmpsScratchData& scratch);

/// Makes pairs of classes F and B that approach below the collision distance part [Mellado2021, eqs. 5.38, 5.39];
/// returns the kinetic energy that they lose [J].
double collide(const WcmpsSettings& settings, ParticleState& state, WcmpsScratchData& scratch);

/// Longest shift and energy of place that shifting took away.
struct Shifting {
    double potential{0};        ///< [J]
    double longest_squared{0};  ///< [m^2]
};

/// Moves particles down the gradient of concentration [Mellado2021, eq. 5.36]:
///
///     delta x = -F grad C,   F = 2 l_0^2 CFL Ma = 2 l_0 dt max|v|,   at most a tenth of l_0,
///
/// class B and F along the surface only, E not.
Shifting shift(const WcmpsSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
               const WcmpsScratchData& scratch);

}  // namespace riprap::fluid::wcmps
