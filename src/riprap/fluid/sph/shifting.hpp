// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// 1 for particles of the surface, 0 for all others, between where it is not clear, from the divergence of position
/// -sum V_j F r^2 [-] [Lee2008].
RIPRAP_HD inline double bareness_of_particle(int dimension, double divergence) {
    // Behind a flat surface at h/dp = 1.5 the rows of a square (cubic) lattice have divergence/dimension = 0.62 (0.67),
    // 0.91 (0.94), 1.00 (1.00).
    constexpr double bare = 0.70, covered = 0.85;
    return std::clamp((covered - divergence / dimension) / (covered - bare), 0.0, 1.0);
}

/// The share of its density that a shift takes from a particle,
///
///     -2 (1 - s) delta x . grad C,
///
/// never negative, s the share of the correction of gradients. Without it density follows the sums of the kernel over
/// neighbours as they change by motion; a shift changes them too, by delta x . grad C at the particle and by as much in
/// all at its neighbours, for which its own s stands here (docs/theory/sph.md, 7). Without this, flow crowds particles,
/// which raises the density, and shifting spreads them, which did not lower it: water swelled. Where gradients are
/// exact, flow crowds particles without raising density, and shifting has nothing to take.
RIPRAP_HD inline double dilution_by_shift(const Vec3& shift, const Vec3& gradient, double corrected) {
    return -2 * (1 - corrected) * dot(shift, gradient);
}

/// Returns the shift of a particle towards even surroundings [m] [Lind2012]:
///
///     delta x = -A h^2 |S| dt grad C,    at most what takes 0.2 % of an uncorrected density,
///
/// with C the concentration of particles. A particle of the surface stays, and those in reach of it move along it
/// only, the less the nearer. Differs from the source: the speed |v| is h |S|, S the rate of strain, so that shifting
/// is the same for every observer and absent in water at rest, in uniform motion and in rotation.
///
/// @param strength   A [-]
/// @param h          smoothing length [m]
/// @param gradient   grad C [1/m]
/// @param towards_surface  sum of V_j b_j grad W over neighbours: zero away from the surface [1/m]
/// @param bareness   b [-]
/// @param strain     |S| = sqrt(2 S:S) [1/s]
/// @param dt         [s]
/// @param steps      sound steps in dt: the most density that is taken is that of as many [-]
RIPRAP_HD inline Vec3 shift_of_particle(double strength, double h, const Vec3& gradient, const Vec3& towards_surface,
                                        double bareness, double strain, double dt, double steps = 1) {
    Vec3 shift = -(strength * h * h * strain * dt * (1 - bareness)) * gradient;
    const double nearness = norm(towards_surface);
    if (nearness > 0) {
        // A bare particle a smoothing length away has h V |grad W| = 0.1 or more: then nothing is left. Gradients are
        // those of a cut support here and would not tell disorder from the surface.
        shift -= (dot(shift, towards_surface) / (nearness * nearness)) * towards_surface;
        shift *= 1 - std::min(1.0, h * nearness / 0.05);
    }
    // Bounds the length too: shifts go along -grad C or what is left of it, so that l^2 <= most A h^2 |S| dt/2, 0.05 dp
    // at A = 10 and |S| dt = 0.1.
    const double loss = dilution_by_shift(shift, gradient, 0);
    const double most = 0.002 * steps;  // of the density, which varies by about 1 % in all
    return (loss > most ? most / loss : 1.0) * shift;
}

/// Returns the density that is left when that share is taken: no more than what lies above the density at rest. Water
/// in tension would be stretched further, and shifting would do work on it (docs/theory/sph.md, 7).
RIPRAP_HD inline double density_after_shift(double density, double dilution, double rest_density) {
    return std::max(std::min(density, rest_density), density * (1 - dilution));
}

}  // namespace riprap::fluid
