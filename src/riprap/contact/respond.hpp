// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/contact_physics.hpp"
#include "riprap/contact/law/frictions.hpp"

namespace riprap::contact {

/// Responds to a normal contact of a pair with all forces: adds it to `found` as `feature`, with its friction,
/// dashpots, surviving springs, and share in the stability of both bodies.
/// @param n  unit vector from A to B, against the normal force on A [-]
/// @returns the row of the contact, valid until the next one is added
ContactRow& respond(const Candidate& pair, const NormalContact& normal, const Vec3& n, std::uint64_t feature,
                    const Frictions& friction, FoundContacts& found);

}  // namespace riprap::contact
