// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/wcmps/wcmps_scratch.hpp"

// Number density from step to step.

namespace riprap::fluid::wcmps {

/// Limits of the classification [JandaghianShakibaeinia2020].
inline constexpr double splash_limit = 0.4;      ///< beta_E of C
inline constexpr double surface_limit = 0.9;     ///< beta_F of C
inline constexpr double neighbour_limit = 0.75;  ///< beta_N of N/N_0

/// kappa: rate, over u/l_0, at which x returns to the concentration that the places of particles have [-].
inline constexpr double volume_return = 1;

/// Finds x, p and q of every particle from its density.
void find_pressure(const WcmpsSettings& settings, const ParticleState& state, WcmpsWater& water);

/// a h rho_0 c_0, h half the support radius [Pa s]. Sound is damped by what forces see as pressure above p,
///
///     s a h rho_0 c_0 (dx/dt)/x,
///
/// dx/dt by the continuity of the last update of density: a bulk viscosity, conjugate to it like the pressure
/// [Sun2023]. s is 1 where water and walls that stand still fill what is around, 0 in two rows at surfaces, where water
/// has no true divergence, and at walls that move: on a light body a resistance is, step by step, an added mass times
/// its velocity (docs/theory/wcmps.md, 4).
double resistance_to_sound(const WcmpsSettings& settings);

/// Adds that to p and q.
void damp_sound(const WcmpsSettings& settings, const WcmpsContinuity& continuity, WcmpsWater& water);

/// Finds b and m of wall particles, and which have a pressure of their own.
void find_wall_shares(const WcmpsSettings& settings, const BoundaryParticles& walls, WcmpsWalls& seen);

/// Changes the density by continuity, diffusion and tearing; leaves C, numbers of neighbours and normals in scratch.
void update_density(const WcmpsSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, double dt, WcmpsScratchData& scratch, FluidReport& report);

}  // namespace riprap::fluid::wcmps
