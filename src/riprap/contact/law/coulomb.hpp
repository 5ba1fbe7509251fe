// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "riprap/contact/contact_kinematics.hpp"
#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/stability.hpp"
#include "riprap/material/material_set.hpp"
#include "riprap/material/property.hpp"

namespace riprap::contact {

/// Tangential response of one contact: incremental Coulomb friction with one spring per contact pair
/// [Zhao, eqs 31-36, corrected],
///
///     f_s <- R f_s - K_s [v - (v.n) n] dt,   |f_s| <= f_n mu + c S_c,
///
/// R turns the old normal into the new one and spins by (omega_A + omega_B).n dt / 2 about the normal; R keeps the
/// length of f_s. K_s = (k_s/k_n) K_n, or the literal shear_stiffness. A spring dies with its contact. The normal force
/// is the elastic one plus a dashpot, never tensile:
///
///     f_n = max(0, |F| + 2 xi sqrt(m_e K_n) v.n),   n from A to B.
///
/// A contact that sticks is damped along its tangential spring by the same ratio, -2 xi sqrt(m_t K_s) [v - (v.n) n], as
/// far as spring and dashpot together stay within the limit; one that slides has friction for that.
///
/// Where torsion is on, the spring acts at an anchor that follows the mean motion of both bodies while the contact
/// sticks, and not at the point of action, which follows the pressure. The anchor adds the couple (anchor - point) x
/// f_s about the point of action, which shares one limit with torsion; sliding draws the anchor to the point by the
/// same share by which it reduces f_s. Without the anchor a load would turn a block about n whenever the pressure moves
/// sideways, and so feed energy into vibrations.
///
/// Torsion (optional): a spring K_s S_c/(2 pi) against relative spin about n, limited by mu times the spin moment of
/// the pressure. It has a dashpot of the same ratio, -2 xi sqrt(J_e K_t) (omega_A - omega_B).n, within the same limit.
/// Differs from the source: c is a stress (the source's "2.14 Pa"), so the cohesive force is c S_c.
///
/// @param normal  elastic normal contact, force on A
/// @param before  springs of the last step, nullptr for a new contact
/// @param after   springs after this step
/// @param row     filled but for the parts and the stability
/// @returns the springs and dashpots that act
LinearContact coulomb(const NormalContact& normal, const material::PairProperties& pair,
                      const ContactKinematics& kinematics, const ShearState* before, ShearState& after,
                      ContactRow& row);

/// The law above as one of contact::Frictions.
struct Coulomb {
    static constexpr std::string_view word = "coulomb";
    static constexpr std::string_view help = "a spring with history";
    static constexpr std::array reads{material::Property::friction, material::Property::cohesion,
                                      material::Property::torsion};

    LinearContact respond(const NormalContact& normal, const material::PairProperties& pair,
                          const ContactKinematics& kinematics, const ShearState* before, ShearState& after,
                          ContactRow& row) const {
        return coulomb(normal, pair, kinematics, before, after, row);
    }
};

}  // namespace riprap::contact
