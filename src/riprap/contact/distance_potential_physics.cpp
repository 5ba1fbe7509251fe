// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/distance_potential_physics.hpp"

#include "riprap/contact/find_contacts.hpp"
#include "riprap/contact/stability.hpp"

namespace riprap::contact {

void DistancePotentialPhysics::find_contacts(const Candidate& pair, SeparatingCache& cache,
                                             FoundContacts& found) const {
    const PairSide &a = pair.a, &b = pair.b;
    NormalContact normal;
    if (!find_contact(a.shape, a.frame, a.material.normal_stiffness, b.shape, b.frame, b.material.normal_stiffness,
                      options, cache, normal)) {
        return;
    }
    const double force = norm(normal.force);
    const Vec3 n = force > 0 ? -normal.force / force : Vec3{0, 0, 1};
    const Mobility mobility_a = mobility_at(a, normal.point, n), mobility_b = mobility_at(b, normal.point, n);

    FoundContact& contact = found.add(feature_key(0, 0));
    const ShearState before = contact.springs;
    const LinearContact linear = friction.visit([&](const auto& law) {
        return law.respond(normal, pair.surfaces, kinematics_at(pair, normal.point, mobility_a, mobility_b),
                           contact.is_old() ? &before : nullptr, contact.springs, contact.row);
    });
    set_stability(linear, mobility_a, mobility_b, contact.row);
}

template double ContactPipeline::find_contacts(const DistancePotentialPhysics& physics, const ContactScene& scene,
                                               const body::BodyState& state, const body::BodyKinematics& kinematics,
                                               double sliding_time, ContactHistory& history);

}  // namespace riprap::contact
