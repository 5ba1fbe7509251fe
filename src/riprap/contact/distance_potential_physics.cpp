// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/distance_potential_physics.hpp"

#include "riprap/contact/corner_foot.hpp"
#include "riprap/contact/find_contacts.hpp"
#include "riprap/contact/narrowphase/separation.hpp"
#include "riprap/contact/respond.hpp"

namespace riprap::contact {

namespace {

bool find_potential(const Candidate& pair, const DistancePotentialOptions& options, SeparatingCache& cache,
                    NormalContact& normal) {
    const PairSide &a = pair.a, &b = pair.b;
    return find_contact(a.shape, a.frame, a.material.normal_stiffness, b.shape, b.frame, b.material.normal_stiffness,
                        options, cache, normal);
}

/// K of faces on each other: half-spaces, whose inscribed radius is infinite, have no field.
double stiffness_per_area(const PairSide& a, const PairSide& b) {
    return a.material.normal_stiffness / a.shape.inscribed_radius +
           b.material.normal_stiffness / b.shape.inscribed_radius;
}

Vec3 direction(const NormalContact& normal) {
    const double force = norm(normal.force);
    return force > 0 ? -normal.force / force : Vec3{0, 0, 1};
}

}  // namespace

void DistancePotentialPhysics::meet(const Candidate& pair, SeparatingCache& cache, FoundContacts& found) const {
    const std::uint64_t only = feature_key(0, 0);
    NormalContact normal;
    if (options.potential != Potential::distance || options.sides != Sides::both) {
        if (find_potential(pair, options, cache, normal)) {
            respond(pair, normal, direction(normal), only, friction, found);
        }
        return;
    }
    const PlacedShape a{pair.a.shape, pair.a.frame}, b{pair.b.shape, pair.b.frame};
    if (!a.is_plane() && !b.is_plane() && is_surely_apart(a.shape, a.frame, b.shape, b.frame, cache)) {
        return;
    }
    const CornerFoot foot(a, b, stiffness_per_area(pair.a, pair.b));
    if (foot.is_whole()) {
        if (!foot.stand(normal)) {
            return;
        }
    } else {
        // Takes the energy of the potential along: what turns the faces asks for it.
        DistancePotentialOptions wanted = options;
        wanted.with_energy = options.with_energy || foot.share() > 0;
        if (!find_potential(pair, wanted, cache, normal)) {
            return;
        }
        if (foot.share() > 0) {
            foot.join(normal);
        }
    }
    if (pair.surfaces.has_torsion && foot.share() > 0) {
        foot.resist_spin(normal);
    }
    ContactRow& row = respond(pair, normal, direction(normal), only, friction, found);
    if (foot.share() > 0) {
        foot.add_tilting(pair, row);
    }
}

template double ContactPipeline::find_contacts(const DistancePotentialPhysics& physics, const ContactScene& scene,
                                               const body::BodyState& state, const body::BodyKinematics& kinematics,
                                               double sliding_time, ContactHistory& history);

}  // namespace riprap::contact
