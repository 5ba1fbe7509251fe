// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/quat.hpp"

namespace riprap::body {

/// Orientation after `dt` of torque-free rotation with angular momentum L (world axes, constant).
///
/// Splitting of the rotor's energy about the principal axes [Dullweber1997],
///
///     H = |L|^2/(2 I_r) + sum_{k != r} (1/I_k - 1/I_r) L_k^2/2,   L_k = (R^T L)_k,
///
/// each part of which turns the body about a fixed axis by a known angle; composed symmetrically
/// (half, whole, half) it is symplectic, time-reversible and of second order, and |L| is untouched. The reference
/// axis r belongs to the pair of closest moments, so that spherical and symmetric tops are exact at any dt. Differs
/// from the source: the spherical part is split off, which leaves two small rotations instead of five large ones.
///
/// @param principal_moments  I_k > 0 [kg m^2]
/// @param principal_axes     principal frame -> body frame
Quat rotate_free(const Quat& orientation, const Vec3& angular_momentum, const Vec3& principal_moments,
                 const Quat& principal_axes, double dt);

}  // namespace riprap::body
