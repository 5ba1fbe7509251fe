// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/sph/sph_scratch.hpp"

namespace riprap::fluid {

/// Extrapolates the pressure of the fluid to wall particles and mirrors its velocity in them, from averages over fluid
/// j [Adami2012, eqs. 22, 23, 27]:
///
///     p_w = max(0, sum (p_j + rho_j (g - a_w).(x_w - x_j)) W / sum W),     u_w = 2 v_w - sum v_j W / sum W.
///
/// Differs from the source: walls never pull.
///
/// @param water  sums over the fluid, which do not depend on how the walls move: sum_at_walls finds them once for
///               given places
/// @param walls  how they move; receives the pressure
/// @param seen   receives u_w and the grip
void extrapolate_to_walls(const SphSettings& settings, const WaterAtWallSums& water, const Vec3& gravity,
                          BoundaryParticles& walls, WallFields& seen);

/// Finds u_w and the grip alone.
void mirror_velocity(const SphSettings& settings, const WaterAtWallSums& water, const BoundaryParticles& walls,
                     WallFields& seen);

}  // namespace riprap::fluid
