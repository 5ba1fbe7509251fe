// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "riprap/core/config.hpp"

namespace riprap::fluid {

/// Share of its density at rest that water at a surface may lack: the 1 % by which density varies in a weakly
/// compressible fluid whose sound is ten times as fast as its flow [Monaghan1994]. That is a tension of 0.01 rho_0
/// c_0^2.
inline constexpr double largest_stretch = 0.01;

/// Tells whether nothing but a wall covers the particle and air is near enough to come between them:
///
///     b_f > b    and    tr M/D < 0.95.
///
/// Deeper down no air can come between, and what falls below rho_0 there is sound (docs/theory/sph.md, 4).
///
/// @param bareness        b, with walls among the neighbours [-]
/// @param bareness_alone  b_f, without walls [-]
/// @param moments         tr M/D, with walls [-]
RIPRAP_HD inline bool may_leave_walls(double bareness, double bareness_alone, double moments) {
    // Rows behind a flat surface have 0.62 (0.67 in 3D), 0.91 (0.94) and 1.00, whether walls stand beside them or not.
    constexpr double reach_of_air = 0.95;
    return bareness_alone > bareness && moments < reach_of_air;
}

/// Returns the gain in density of a particle as water tears there [kg/m^3]:
///
///     max(0, rho_0 - rho)                 where it may leave a wall,
///     max(0, (1 - 0.01/b) rho_0 - rho)    elsewhere, nothing where b = 0.
///
/// Water in air holds no tension, but continuity makes one of c_0^2 (rho - rho_0) where particles fly apart. A lack of
/// 2 % of the density stops particles that part at v = 0.02 c_0; one of 7 % draws two of them into one place, where the
/// kernel has no slope left to part them. And a wall does not pull: where a stream passes its edge, continuity takes
/// the wall that is left behind for water that thins out. Tearing takes energy of compression away and gives none
/// (docs/theory/sph.md, 4).
///
/// @param bareness      b: 1 at the surface, 0 inside [-]
/// @param leaves_wall   what may_leave_walls says
/// @param density       rho [kg/m^3]
/// @param rest_density  rho_0 [kg/m^3]
RIPRAP_HD inline double density_by_tearing(double bareness, bool leaves_wall, double density, double rest_density) {
    if (leaves_wall) {
        return std::max(0.0, rest_density - density);
    }
    return bareness > 0 ? std::max(0.0, (1 - largest_stretch / bareness) * rest_density - density) : 0;
}

/// Returns the share to which a particle is caught alone between two walls:
///
///     l = max(0, 1 - (tr M_f/D)/c) (tr M/D - 0.65)/0.15,    c = 0.05 + 0.2 (tr M/D - 0.95)/0.05,
///
/// each fraction in tr M/D between 0 and 1. Water that walls squeeze leaves along the gap, and its pressure goes with
/// sound by its free sides. Continuity sees the walls come nearer and no side: particles two and more spacings apart
/// would carry a block like rigid balls. So B is taken times 1 - l: such a particle feels no compression, passes on no
/// pressure and fills nothing of a joint (docs/theory/sph.md, 4).
///
/// @param alone    tr M_f/D, of its neighbours in the water: 0.08 in a row (2D) with twice the spacing [-]
/// @param moments  tr M/D, with walls, for a particle alone at h/dp = 1.5: 0.90, 0.74, 0.60 in the middle of a gap of
///                 0.4, 1, 1.5 spacings (0.89, 0.67, 0.51 in 3D) and 0.45 at one wall, but 0.70 and 0.83 a fifth of a
///                 spacing from two and three walls that make a corner, where a single drop counts as caught too [-]
RIPRAP_HD inline double caught_share(double alone, double moments) {
    constexpr double open = 0.65, enclosed = 0.8, narrow = 0.95, shut = 1.0;
    const double company = 0.05 + 0.2 * std::clamp((moments - narrow) / (shut - narrow), 0.0, 1.0);
    return std::max(0.0, 1 - alone / company) * std::clamp((moments - open) / (enclosed - open), 0.0, 1.0);
}

/// Returns the share of its sound that leaves a caught particle in a step, 1 - exp(-c_0 dt/dp) [-].
/// @param passed  c_0 dt/dp [-]
inline double escape_in_step(double passed) { return 1 - std::exp(-passed); }

/// Returns the gain in density of a caught particle as that sound leaves:
///
///     max(0, 2 l - 1) (rho_0 - rho) (1 - exp(-c_0 dt/dp)).                       [kg/m^3]
///
/// @param caught        l
/// @param density       rho [kg/m^3]
/// @param rest_density  rho_0 [kg/m^3]
/// @param gone          what escape_in_step gives
RIPRAP_HD inline double density_by_escape(double caught, double density, double rest_density, double gone) {
    const double share = std::max(0.0, 2 * caught - 1);
    return share > 0 ? share * (rest_density - density) * gone : 0;
}

}  // namespace riprap::fluid
