// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/affine/blocks.hpp"

namespace riprap::solid::explicit_dda {

/// Highest squared frequency of the strain modes of a block [1/s^2]: V max(3 lambda + 2 mu, 2 mu) / s_min, s_min the
/// least eigenvalue of its second moments; for a cube of side L exactly 12 E/((1 - 2 nu) rho L^2).
double strain_frequency_squared(const affine::Elasticity& material, double volume, const Mat3& inertia);

/// Mobility of a block under a force at r from the centroid, 1/m + r S^-1 r [1/kg]: a bound for any direction; a
/// corner of a cube has 10/m.
double mobility(double mass, const Mat3& inverse_inertia, const Vec3& arm);

/// Largest stable step for frequencies and damping: dt^2 w2/4 + dt damping/2 <= 1 [s].
double step_of(double frequency_squared, double damping);

}  // namespace riprap::solid::explicit_dda
