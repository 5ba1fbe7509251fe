// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/contact/contact_set.hpp"

namespace riprap::contact {

/// A contact as frames, page and Python show it, whatever the method.
struct ShownContact {
    BodyId a, b;
    Vec3 point;              ///< where the force acts [m]
    Vec3 force;              ///< total on a; b gets the opposite [N]
    double normal_force{0};  ///< size of the normal force, damping included; negative where a bond pulls [N]
    double shear_force{0};   ///< size of the tangential force [N]
    double overlap{0};       ///< [m]
    double area{0};          ///< 0 where the method knows none [m^2]
    double potential{0};     ///< largest normalised potential, of methods that tell it (sim/method_traits.hpp) [-]
    bool is_sliding{false};
};

/// Returns a contact by its force on a and its normal from a to b.
ShownContact shown_contact(BodyId a, BodyId b, const Vec3& point, const Vec3& force, const Vec3& normal);

/// Adds contacts between parts.
void show_rows(const ContactRows& rows, const body::BodySet& bodies, std::vector<ShownContact>& shown);

}  // namespace riprap::contact
