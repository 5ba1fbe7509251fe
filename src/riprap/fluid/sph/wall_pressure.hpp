// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/sph/sph_scratch.hpp"

namespace riprap::fluid {

/// Pressure of the fluid at wall particles and its velocity mirrored in them, from averages over fluid j
/// [Adami2012, eqs. 22, 23, 27]:
///
///     p_w = max(0, sum (p_j + rho_j (g - a_w).(x_w - x_j)) W / sum W),     u_w = 2 v_w - sum v_j W / sum W.
///
/// Differs from the source: walls never pull.
///
/// The sums over fluid do not depend on how the wall moves: sum_at_walls finds them once for given places.
///
/// Writes walls.pressure, scratch.mirrored_velocity and scratch.grip from those sums and from how the walls move.
void extrapolate_to_walls(BoundaryParticles& walls, const Vec3& gravity, SphScratchData& scratch);

}  // namespace riprap::fluid
