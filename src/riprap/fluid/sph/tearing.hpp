// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::fluid {

/// Share of its density at rest that water at a surface may lack: the 1 % by which density varies in a weakly
/// compressible fluid whose sound is ten times as fast as its flow [Monaghan1994]. That is a tension of 0.01 rho_0
/// c_0^2.
inline constexpr double largest_stretch = 0.01;

/// Whether nothing but a wall covers the particle and air is near enough to come between the two:
///
///     b_f > b    and    tr M/D < 0.95.
///
/// Deeper down no air can come between, and what falls below rho_0 there is sound (docs/theory/sph.md, 4).
///
/// @param bareness        b, with walls among the neighbours [-]
/// @param bareness_alone  b_f, without walls [-]
/// @param moments         tr M/D, with walls [-]
bool may_leave_walls(double bareness, double bareness_alone, double moments);

/// What a particle gains in density as water tears there [kg/m^3]:
///
///     max(0, rho_0 - rho)                 where it may leave a wall,
///     max(0, (1 - 0.01/b) rho_0 - rho)    elsewhere, nothing where b = 0.
///
/// Water in air holds no tension, but continuity makes one of c_0^2 (rho - rho_0) where particles fly apart: 2 % of the
/// density stop them at v = 0.02 c_0, and 7 % pay for two that fall together, where the kernel has no slope left to
/// part them. And a wall does not pull: where a stream passes its edge, continuity takes the wall that is left behind
/// for water that thins out. Tearing takes energy of compression away and gives none (docs/theory/sph.md, 4).
///
/// @param bareness      b: 1 at the surface, 0 inside [-]
/// @param leaves_wall   what may_leave_walls says
/// @param density       rho [kg/m^3]
/// @param rest_density  rho_0 [kg/m^3]
double density_by_tearing(double bareness, bool leaves_wall, double density, double rest_density);

}  // namespace riprap::fluid
