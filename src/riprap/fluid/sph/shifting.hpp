// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {

/// 1 for particles of the surface, 0 for all others, between where it is not clear, from the divergence of position
/// -sum V_j F r^2 [-] [Lee2008].
double bareness_of_particle(int dimension, double divergence);

/// Returns the shift of a particle towards even surroundings [m] [Lind2012]:
///
///     delta x = -A h^2 |S| dt grad C,    at most what takes 0.2 % of an uncorrected density,
///
/// with C the concentration of particles. A particle of the surface stays, and those in reach of it move along it
/// only, the less the nearer. Differs from the source: the speed |v| is h |S|, S the rate of strain, so that shifting
/// is the same for every observer and absent in water at rest, in uniform motion and in rotation.
///
/// @param gradient   grad C [1/m]
/// @param towards_surface  sum of V_j b_j grad W over neighbours: zero away from the surface [1/m]
/// @param bareness   b [-]
/// @param strain     |S| = sqrt(2 S:S) [1/s]
/// @param dt         [s]
Vec3 shift_of_particle(const SphSettings& settings, const Vec3& gradient, const Vec3& towards_surface, double bareness,
                       double strain, double dt);

/// The share of its density that a shift takes from a particle,
///
///     -2 (1 - s) delta x . grad C,
///
/// never negative, s the share of the correction of gradients. Without it density follows the sums of the kernel over
/// neighbours as they change by motion; a shift changes them too, by delta x . grad C at the particle and by as much in
/// all at its neighbours, for which its own s stands here (docs/theory/sph.md, 7). Without this, flow crowds particles,
/// which raises the density, and shifting spreads them, which did not lower it: water swelled. Where gradients are
/// exact, flow crowds particles without raising density, and shifting has nothing to take.
double dilution_by_shift(const Vec3& shift, const Vec3& gradient, double corrected);

/// Returns the density that is left when that share is taken: no more than what lies above the density at rest. Water
/// in tension would be stretched further, and shifting would do work on it (docs/theory/sph.md, 7).
double density_after_shift(double density, double dilution, double rest_density);

}  // namespace riprap::fluid
