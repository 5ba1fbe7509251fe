// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/core/vec3.hpp"

namespace riprap::coupling {

/// A sample at the rim of a joint.
struct RimPart {
    Vec3 place{};        ///< from any point, the same for all; nearest images where sides are periodic [m]
    Vec3 inward{};       ///< t/|t|, along the face into the solids
    double strength{0};  ///< s V, see JointPressure; above 0 [m^D]
};

/// Returns a factor a_r on the strength of each part, by which a length of rim counts alike whatever the angle of the
/// face above it. The row of samples above the joint ends at that face, so that a sharp toe has more of it within h
/// than an upright face and an overhang has less: an uplift that falls from a wet end to a dry one would lean towards
/// the stronger end.
///
///     a_r = D/max(D_r, D/2),   D_r = sum_q s_q V_q max(0, e_q . e_r) max(0, 1 - |x_q - x_r|^2/R^2),
///
/// where e is the direction of t, D the mean of D_r by s V and R the reach. Parts of other ends, which look the other
/// way, do not count; uneven samples inside a joint, few and weak, count for twice of what they are at most.
/// @param reach  R, more than the pieces of one rim lie apart across it [m]
std::vector<double> even_rim(std::span<const RimPart> parts, double reach);

}  // namespace riprap::coupling
