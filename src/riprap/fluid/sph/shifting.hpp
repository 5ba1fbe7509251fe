// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {

/// How far to move a particle so that its neighbours surround it evenly [m] [Lind2012]:
///
///     delta x = -A h^2 |S| dt f grad C,    at most a tenth of the spacing,
///
/// with C the concentration of particles and f a factor that falls from 1 to 0 as the divergence of position shows the
/// surface: nothing moves at or towards it. Differs from the source: the speed |v| is h |S|, S the rate of strain, so
/// that shifting is the same for every observer and absent in water at rest, in uniform motion and in rotation.
///
/// @param gradient    grad C [1/m]
/// @param divergence  of position [-]: the dimension inside the water, less near its surface
/// @param strain      |S| = sqrt(2 S:S) [1/s]
/// @param dt          [s]
Vec3 shift_of_particle(const SphSettings& settings, const Vec3& gradient, double divergence, double strain, double dt);

}  // namespace riprap::fluid
