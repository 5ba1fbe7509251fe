// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/affine/block_contacts.hpp"

namespace riprap::solid::implicit_dda {

using affine::ContactMode;

/// Springs and strength of one contact point in one step.
struct ContactSprings {
    double normal{0}, shear{0};  ///< k_n, k_s [N/m]
    double friction{0};          ///< tan phi [-]
    double cohesion{0};          ///< c A_c while intact [N]
    double tension{0};           ///< tensile strength times A_c while intact [N]
};

/// A contact point during the iteration.
struct ContactTrial {
    ContactMode mode{ContactMode::open};
    bool is_intact{false};
    Vec3 slip_before{};      ///< elastic slip at the start of the step, in the plane [m]
    double gap{0};           ///< d_n of the last solution [m]
    Vec3 slip{};             ///< elastic slip plus the motion of the step, in the plane [m]
    Vec3 step_slip{};        ///< motion of the step alone, a against b, in the plane [m]
    double friction{0};      ///< F_f that acts while sliding [N]
    Vec3 direction{};        ///< of sliding, a against b [-]
    bool has_locked{false};  ///< went from sliding to lock in this step; if it slides again, it goes on sliding
};

/// When sliding ends.
struct OpenCloseRule {
    double close_tolerance{0};   ///< an open contact closes below minus this gap [m]
    double open_tolerance{0};    ///< a closed one opens above this gap [m]
    double slide_tolerance{-1};  ///< >= 0: sliding locks when the slip of the step is below it, as the source has it
                                 ///< [m]; < 0: when the slip turns back
};

/// Strength k_n |d_n| tan phi + C at a trial [N].
double strength(const ContactSprings& springs, const ContactTrial& trial);

/// The next mode after a solution [Ding2021, table 4.2]:
///
///     open  -> lock or slide  where d_n < 0, by k_s d_t against k_n |d_n| tan phi + C
///     slide -> open           where d_n > 0;  -> lock where the slip turns back (or falls below a tolerance)
///     lock  -> open           where d_n > 0 (tension T/k_n while intact);  -> slide where k_s d_t passes the strength
///
/// A contact that slides again after it has locked in the same step goes on sliding: at the limit of friction both
/// answers are near, and the iteration would go from one to the other for ever. Sets friction and direction of what
/// slides. @returns true when springs came or went
bool update_mode(const ContactSprings& springs, const OpenCloseRule& rule, ContactTrial& trial);

}  // namespace riprap::solid::implicit_dda
