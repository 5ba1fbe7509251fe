// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/sph/sph_scratch.hpp"
#include "riprap/fluid/sph/wall_loops.hpp"

namespace riprap::fluid {

/// Finds u_w (see extrapolate_to_walls) and the grip alone.
template <class Where>
void mirror_velocity(const SphSettings& settings, const WaterAtWallSumsIn<Where>& water, const WallColumns& walls,
                     WallFieldsIn<Where>& seen) {
    const auto count = static_cast<std::size_t>(walls.count);
    seen.mirrored_velocity.resize(count, settings.is_plain);
    seen.grip.resize(count, settings.is_plain);
    Where::for_each(walls.count, MirrorVelocity{walls, water.weight.columns(), water.velocity.columns(),
                                                seen.mirrored_velocity.columns(), seen.grip.columns()});
}

template <class Where>
PressureAtWall pressure_at_wall(const WaterAtWallSumsIn<Where>& water) {
    return {water.weight.columns(), water.pressure.columns(), water.moment.columns()};
}

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
template <class Where>
void extrapolate_to_walls(const SphSettings& settings, const WaterAtWallSumsIn<Where>& water, const Vec3& gravity,
                          const WallColumns& walls, WallFieldsIn<Where>& seen) {
    mirror_velocity(settings, water, walls, seen);
    Where::for_each(walls.count, ExtrapolateToWall{walls, pressure_at_wall(water), gravity});
}

}  // namespace riprap::fluid
