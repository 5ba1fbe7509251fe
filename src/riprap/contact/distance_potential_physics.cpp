// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/distance_potential_physics.hpp"

#include "riprap/contact/find_contacts.hpp"
#include "riprap/contact/respond.hpp"

namespace riprap::contact {

void DistancePotentialPhysics::meet(const Candidate& pair, SeparatingCache& cache, FoundContacts& found) const {
    const PairSide &a = pair.a, &b = pair.b;
    NormalContact normal;
    if (!find_contact(a.shape, a.frame, a.material.normal_stiffness, b.shape, b.frame, b.material.normal_stiffness,
                      options, cache, normal)) {
        return;
    }
    const double force = norm(normal.force);
    respond(pair, normal, force > 0 ? -normal.force / force : Vec3{0, 0, 1}, feature_key(0, 0), friction, found);
}

template double ContactPipeline::find_contacts(const DistancePotentialPhysics& physics, const ContactScene& scene,
                                               const body::BodyState& state, const body::BodyKinematics& kinematics,
                                               double sliding_time, ContactHistory& history);

}  // namespace riprap::contact
