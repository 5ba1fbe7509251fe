// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/law/joint_laws.hpp"
#include "riprap/core/vec3.hpp"

namespace riprap::contact {

/// Springs, dashpots and strength of one contact point.
struct PenaltySprings {
    double normal_stiffness{0};  ///< k_n [N/m]
    double shear_stiffness{0};   ///< k_s [N/m]
    double friction{0};          ///< tan phi [-]
    double cohesion{0};          ///< c times the area of the point, while intact [N]
    double tension{0};           ///< tensile strength times the area, while intact [N]
    double bond_slip{0};         ///< plastic slip after which a bond has broken [m]
    double normal_damping{0};    ///< [N s/m]
    double shear_damping{0};     ///< of a contact that sticks [N s/m]
};

/// A contact point now, bodies a and b.
struct PenaltyMotion {
    Vec3 normal;             ///< from a to b [-]
    double gap;              ///< negative where they overlap [m]
    Vec3 velocity;           ///< v_a - v_b there [m/s]
    double time;             ///< since the last evaluation [s]
    Vec3 slip;               ///< elastic slip of the last evaluation, turned to the present plane [m]
    bool is_intact;          ///< bonded: has neither opened nor slid by more than bond_slip
    double plastic_slip{0};  ///< by which the intact bond has slid so far [m]
};

/// The answer of the springs. Forces on a; b gets the opposite.
struct PenaltyAnswer {
    Vec3 force{};            ///< [N]
    double normal_force{0};  ///< pushing positive [N]
    Vec3 slip{};             ///< elastic slip to be kept [m]
    bool is_open{false};     ///< no force: forget the contact
    bool is_sliding{false};
    bool is_intact{false};
    double plastic_slip{0};   ///< of a bond that is still intact [m]
    double energy{0};         ///< stored in both springs [J]
    double friction_loss{0};  ///< taken by sliding since the last evaluation, against the mean of the spring's forces
                              ///< then and now; of a bond that this slip has broken: what the spring gives up [J]
    Vec3 dashpot{};           ///< the part of the force that is due to the dashpots [N]
};

/// Penalty contact with friction [MikolaSitar2013], one point at a time:
///
///     f_n = -k_n g + c_n v.n,  at least 0 (or minus the tensile strength while intact),
///     t  <- t + (v - (v.n) n) dt,   f_s = -k_s t - c_s v_t,   |f_s| <= S(f_n, C),
///
/// n from a to b, v = v_a - v_b, S the strength by the joint law, of Coulomb f_n tan phi + C. Where the limit is passed
/// the contact slides: t is shortened to it, and friction takes the slip lost times the mean force over the time: a
/// limit that grew from nothing took half as much. A bond that has slid by more than bond_slip in all breaks: cohesion
/// C and tension are lost for good and t is shortened to S(f_n, 0)/k_s; one that slides while it is apart opens.
/// Stiffness per area with the area of the point makes it the soft contact of [Ding2021, eq. 2.10].
PenaltyAnswer penalty(const JointLaws& law, const PenaltySprings& springs, const PenaltyMotion& motion);

}  // namespace riprap::contact
