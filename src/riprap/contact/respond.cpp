// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/respond.hpp"

#include "riprap/contact/stability.hpp"

namespace riprap::contact {

ContactRow& respond(const Candidate& pair, const NormalContact& normal, const Vec3& n, std::uint64_t feature,
                    const Frictions& friction, FoundContacts& found) {
    const Mobility a = mobility_at(pair.a, normal.point, n), b = mobility_at(pair.b, normal.point, n);
    FoundContact& contact = found.add(feature);
    const ShearState before = contact.springs;
    const LinearContact linear = friction.visit([&](const auto& law) {
        return law.respond(normal, pair.surfaces, kinematics_at(pair, normal.point, a, b),
                           contact.is_old() ? &before : nullptr, contact.springs, contact.row);
    });
    set_stability(linear, a, b, contact.row);
    return contact.row;
}

}  // namespace riprap::contact
