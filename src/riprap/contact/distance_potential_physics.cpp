// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/distance_potential_physics.hpp"

#include "riprap/contact/corner_foot.hpp"
#include "riprap/contact/find_contacts.hpp"
#include "riprap/contact/narrowphase/separation.hpp"
#include "riprap/contact/respond.hpp"
#include "riprap/contact/round_push.hpp"
#include "riprap/contact/sharp_push.hpp"

namespace riprap::contact {

namespace {

/// K of faces on each other: half-spaces, whose inscribed radius is infinite, have no field.
double stiffness_per_area(const PressedShape& a, const PressedShape& b) {
    return a.stiffness / a.placed.shape.inscribed_radius + b.stiffness / b.placed.shape.inscribed_radius;
}

bool find_potential(const PressedShape& a, const PressedShape& b, const DistancePotentialOptions& options,
                    SeparatingCache& cache, NormalContact& normal) {
    return find_contact(a.placed.shape, a.placed.frame, a.stiffness, b.placed.shape, b.placed.frame, b.stiffness,
                        options, cache, normal);
}

bool find_with_foot(const CornerFoot& foot, const PressedShape& a, const PressedShape& b,
                    const DistancePotentialOptions& options, SeparatingCache& cache, NormalContact& normal) {
    if (foot.is_whole()) {
        return foot.stand(normal);
    }
    // Takes the energy of the potential along: what turns the faces asks for it.
    const bool is_stiff = options.corners == Corners::stiff && a.placed.shape.is_sharp && b.placed.shape.is_sharp;
    DistancePotentialOptions wanted = options;
    wanted.with_energy = options.with_energy || foot.share() > 0 || is_stiff;
    if (!find_potential(a, b, wanted, cache, normal)) {
        return false;
    }
    if (is_stiff) {
        // Of a half-space, which has no size of its own, and of a much larger body the modulus counts, not the size.
        const double modulus = a.stiffness + b.stiffness;
        const double radius = std::min(a.placed.shape.inscribed_radius, b.placed.shape.inscribed_radius);
        SharpPush(modulus, std::max(stiffness_per_area(a, b), modulus / (2 * radius)),
                  a.placed.shape.is_planar || b.placed.shape.is_planar)
            .stiffen(normal);
    }
    if (foot.share() > 0) {
        foot.join(normal);
    }
    return true;
}

bool has_feet(const DistancePotentialOptions& options) {
    return options.potential == Potential::distance && options.sides == Sides::both;
}

PressedShape pressed(const PairSide& side) { return {{side.shape, side.frame}, side.material.normal_stiffness}; }

Vec3 direction(const NormalContact& normal) {
    const double force = norm(normal.force);
    return force > 0 ? -normal.force / force : Vec3{0, 0, 1};
}

}  // namespace

bool find_push(const PressedShape& a, const PressedShape& b, const DistancePotentialOptions& options,
               SeparatingCache& cache, NormalContact& normal) {
    if (has_feet(options) && options.corners == Corners::stiff) {
        const RoundPush round(a.placed, a.stiffness, b.placed, b.stiffness);
        if (round.is_round()) {
            Vec3 n;
            return round.push(normal, n);
        }
    }
    return has_feet(options) ? find_with_foot(CornerFoot(a.placed, b.placed, stiffness_per_area(a, b), options.corners),
                                              a, b, options, cache, normal)
                             : find_potential(a, b, options, cache, normal);
}

void DistancePotentialPhysics::meet(const Candidate& pair, SeparatingCache& cache, FoundContacts& found) const {
    const std::uint64_t only = feature_key(0, 0);
    const PressedShape a = pressed(pair.a), b = pressed(pair.b);
    NormalContact normal;
    if (!has_feet(options)) {
        if (find_potential(a, b, options, cache, normal)) {
            respond(pair, normal, direction(normal), only, friction, found);
        }
        return;
    }
    if (!a.placed.is_plane() && !b.placed.is_plane() &&
        is_surely_apart(pair.a.shape, pair.a.frame, pair.b.shape, pair.b.frame, cache)) {
        return;
    }
    if (options.corners == Corners::stiff) {
        const RoundPush round(a.placed, a.stiffness, b.placed, b.stiffness);
        if (round.is_round()) {
            if (Vec3 n; round.push(normal, n)) {
                respond(pair, normal, n, only, friction, found);
            }
            return;
        }
    }
    const CornerFoot foot(a.placed, b.placed, stiffness_per_area(a, b), options.corners);
    if (!find_with_foot(foot, a, b, options, cache, normal)) {
        return;
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
