// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/law/joint_laws.hpp"
#include "riprap/solid/affine/block_contacts.hpp"

namespace riprap::solid::implicit_dda {

using affine::ContactMode;

/// Springs and strength of one contact point in one step.
struct ContactSprings {
    double normal{0}, shear{0};  ///< k_n, k_s [N/m]
    double friction{0};          ///< tan phi [-]
    double cohesion{0};          ///< c A_c while intact [N]
    double tension{0};           ///< tensile strength times A_c while intact [N]
    double bond_length{0};       ///< slip or gap by which a bond is lost; see affine/bonds.hpp [m]
};

/// A contact point during the open-close iteration.
struct ContactTrial {
    ContactMode mode{ContactMode::open};
    bool is_intact{false};
    Vec3 slip_before{};      ///< elastic slip at the start of the step, in the plane [m]
    double gap{0};           ///< d_n of the last solution [m]
    Vec3 slip{};             ///< elastic slip plus the motion of the step, in the plane [m]
    Vec3 step_slip{};        ///< motion of the step alone, a against b, in the plane [m]
    double friction{0};      ///< F_f, the friction while sliding [N]
    Vec3 direction{};        ///< l of sliding, a against b [-]
    double across{0};        ///< stiffness F_f/|t| with which friction turns with the slip [N/m]
    bool has_locked{false};  ///< went from sliding to lock in this step; if it slides again, it goes on sliding
    double change{0};        ///< of the friction while sliding, in the last round [N]
    double plastic_slip{0};  ///< of the intact bond before the step [m]
    double residual{0};      ///< friction that is left while sliding where a bond has broken [N]
};

/// When sliding ends.
struct OpenCloseRule {
    double close_tolerance{0};   ///< an open contact closes below minus this gap [m]
    double open_tolerance{0};    ///< a closed one opens above this gap [m]
    double slide_tolerance{-1};  ///< >= 0: sliding locks when the slip of the step is below the tolerance, as in the
                                 ///< source [m]; < 0: when the slip turns back
    contact::JointLaws law{};
};

/// Strength S of a contact point at a trial, by its push k_n |d_n| [N].
double strength(const contact::JointLaws& law, const ContactSprings& springs, const ContactTrial& trial);

/// The next mode after a solution [Ding2021, table 4.2]:
///
///     open  -> lock or slide  where d_n < 0, by k_s |t| against S
///     slide -> open           where d_n > 0;  -> lock where k_s |t| falls below the strength or t turns back
///     lock  -> open           where d_n > 0 (tension T/k_n while intact);  -> slide where k_s |t| passes the strength
///
/// S is the strength by the joint law, of Coulomb k_n |d_n| tan phi + C; t is the elastic slip at the start of the step
/// plus the motion of the step: the elastic-plastic spring of Coulomb's law. A contact that slides gets the friction
/// F_f, its direction l = t/|t|, and the stiffness F_f/|t| across l in the plane, the derivative of F_f t/|t|; without
/// that stiffness the direction would not converge where blocks are soft. Differs from the source, which locks by the
/// slip of the step. A contact that slides again after it has locked in the same step stays sliding: at the limit both
/// modes give nearly the same force.
/// @returns true when springs came or went
bool update_mode(const ContactSprings& springs, const OpenCloseRule& rule, ContactTrial& trial);

}  // namespace riprap::solid::implicit_dda
