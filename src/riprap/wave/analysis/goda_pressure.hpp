// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::wave {

/// A wall on a mound, and the sea in front of it.
struct GodaWall {
    double highest, significant;  ///< H_max and H_1/3 [m]
    double period;                ///< T_1/3 [s]
    double depth;                 ///< h, of still water in front of the mound [m]
    double depth_at_wall;         ///< d, above the armour of the mound [m]
    double foot;                  ///< h', foot of the wall below still water [m]
    double crest;                 ///< h_c, top of the wall above it [m]
    double foreshore;             ///< tangent of the slope of the bed [-]
    double angle;    ///< beta, of the waves to the normal of the wall, turned by 15 degrees towards it [rad]
    double density;  ///< of the water [kg/m^3]
};

/// Pressures of the highest wave, over still water.
struct GodaPressure {
    double reach;                        ///< eta*, height up to which there is pressure [m]
    double at_level, at_foot, at_crest;  ///< p_1, p_3, p_4 [Pa]
    double uplift;                       ///< p_u, at the front edge of the foot [Pa]
    double force;                        ///< (p_1 + p_3) h'/2 + (p_1 + p_4) h_c*/2 per metre [N/m]
};

/// Goda's pressures of waves that do not break impulsively [Goda2000, sec. 4.2.2]:
///
///     eta* = 0.75 (1 + cos beta) H_max,  p_1 = (1 + cos beta)/2 (a_1 + a_2 cos^2 beta) rho g H_max,
///     p_3 = a_3 p_1,  p_4 = p_1 (1 - h_c/eta*) from 0,  p_u = (1 + cos beta)/2 a_1 a_3 rho g H_max,
///     a_1 = 0.6 + (2 k h/sinh 2 k h)^2/2,  a_2 = min((h_b - d)/(3 h_b) (H_max/d)^2, 2 d/H_max),
///     a_3 = 1 - h'/h (1 - 1/cosh k h),
///
/// h_b the depth five H_1/3 in front of the wall, k by linear theory.
GodaPressure goda_pressure(const GodaWall& wall);

}  // namespace riprap::wave
