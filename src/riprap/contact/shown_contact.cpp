// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/shown_contact.hpp"

#include "riprap/core/index.hpp"

namespace riprap::contact {

ShownContact shown_contact(BodyId a, BodyId b, const Vec3& point, const Vec3& force, const Vec3& normal) {
    const double push = -dot(force, normal);
    return {.a = a,
            .b = b,
            .point = point,
            .force = force,
            .normal_force = push,
            .shear_force = norm(force + push * normal)};
}

void show_rows(const ContactRows& rows, const body::BodySet& bodies, std::vector<ShownContact>& shown) {
    for (const ContactRow& row : rows) {
        shown.push_back({.a = bodies.parts[at(row.parts.a)].body,
                         .b = bodies.parts[at(row.parts.b)].body,
                         .point = row.point,
                         .force = row.force,
                         .normal_force = row.normal_force,
                         .shear_force = row.shear_force,
                         .overlap = row.overlap,
                         .area = row.area,
                         .potential = row.potential,
                         .is_sliding = row.is_sliding != 0});
    }
}

}  // namespace riprap::contact
