// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/remedy/contact_need.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "riprap/body/may_move.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/run/remedy/predicted_contact.hpp"
#include "riprap/run/remedy/remedy_text.hpp"
#include "riprap/scene/warnings/initial_overlaps.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/shown.hpp"
#include "riprap/solid/travel_bound.hpp"

namespace riprap::run {

namespace {

/// Factor on the stiffness that just carries a block let go on its face: what comes down on a corner, or on a stack
/// that it takes along, presses harder.
constexpr double reserve = 4;

/// The deepest contact of a step.
struct Deepest {
    BodyId a, b;
    double overlap{0};   ///< [m]
    Vec3 force{};        ///< on a, of all contacts of the two bodies together, with that of dashpots [N]
    bool is_of_faces{};  ///< of the distance potential or across a common plane, not of spheres
};

bool is_of(const contact::ShownContact& row, BodyId a, BodyId b) {
    return (row.a.value == a.value && row.b.value == b.value) || (row.a.value == b.value && row.b.value == a.value);
}

/// Returns the deepest of the contacts; by the shapes themselves where the method tells no depth and there are two that
/// lie in each other. No bodies where nothing touches.
Deepest find_deepest(const Refused& refused, const std::vector<contact::ShownContact>& rows) {
    Deepest found;
    double potential = 0;
    for (const contact::ShownContact& row : rows) {
        if (std::isfinite(row.overlap) && row.overlap > 0 &&
            (row.potential > potential || (potential == 0 && row.overlap > found.overlap))) {
            potential = row.potential;
            found = {row.a, row.b, row.overlap, {}, row.potential > 0};
        }
    }
    if (potential == 0 && find_non_finite(refused.after.bodies).name.empty()) {
        for (const scene::InitialOverlap& deep :
             scene::find_initial_overlaps(refused.model, refused.after, solid::most_overlap)) {
            found = {deep.a, deep.b, deep.depth, {}, false};
            break;
        }
    }
    for (const contact::ShownContact& row : rows) {
        if (found.overlap > 0 && is_of(row, found.a, found.b)) {
            found.force += row.a.value == found.a.value ? row.force : -row.force;
        }
    }
    return found;
}

double thickness_of(const sim::Model& model, BodyId body) {
    double least = std::numeric_limits<double>::infinity();
    for (std::int32_t p = model.bodies.part_begin[at(body.value)]; p < model.bodies.part_begin[at(body.value) + 1];
         ++p) {
        least = std::min(least, model.shapes.view(model.bodies.parts[at(p)].shape).inscribed_radius);
    }
    return least;
}

/// What one side of a contact brings against the other.
struct Side {
    double energy{0}, mass{0};
    BodyId driven{};  ///< body of this side that drives it against the other; invalid without one
    bool is_held{false};
    bool is_backed{false};  ///< what stands behind it moves as told, or not at all
};

/// Adds up the bodies that touch `first`, and those that touch these, without the other side of the contact.
Side side_of(const Refused& refused, const std::vector<contact::ShownContact>& rows, BodyId first, BodyId other) {
    const body::BodySet& bodies = refused.model.bodies;
    const body::BodyState& state = refused.after.bodies;
    std::vector<std::uint8_t> is_met(at(bodies.size()), 0);
    std::vector<std::int32_t> left{first.value};
    is_met[at(first.value)] = is_met[at(other.value)] = 1;
    Side side;
    while (!left.empty()) {
        const std::int32_t b = left.back();
        left.pop_back();
        const Vec3 velocity = state.velocity[at(b)] - state.velocity[at(other.value)];
        if (!is_free(bodies, BodyId{b}, refused.after.time)) {
            side.is_held = side.is_held || b == first.value;
            side.is_backed = side.is_backed || b != first.value;
            side.driven = bodies.drive[at(b)] == body::Drive::driven && norm(velocity) > 0 ? BodyId{b} : side.driven;
            continue;  // what stands behind it presses on it alone
        }
        const Vec3 spin = angular_velocity(bodies, state, BodyId{b});
        side.mass += bodies.mass[at(b)];
        side.energy += 0.5 * bodies.mass[at(b)] * norm_squared(velocity) +
                       0.5 * std::max(0.0, dot(spin, state.angular_momentum[at(b)]));
        for (const contact::ShownContact& row : rows) {
            for (const auto& [here, there] : {std::pair(row.a, row.b), std::pair(row.b, row.a)}) {
                if (here.value == b && is_met[at(there.value)] == 0) {
                    is_met[at(there.value)] = 1;
                    left.push_back(there.value);
                }
            }
        }
    }
    return side;
}

/// The time at which a driven body came to touch what it presses, as far as the overlaps tell [s].
double touched_at(const Refused& refused, const std::vector<contact::ShownContact>& rows, BodyId driven) {
    const double speed = norm(refused.after.bodies.velocity[at(driven.value)]);
    double pressed = 0;
    for (const contact::ShownContact& row : rows) {
        pressed += std::isfinite(row.overlap) ? row.overlap : 0;
    }
    return std::max(0.1 * refused.after.time, refused.after.time - 0.9 * pressed / speed);
}

/// Returns the factor on the stiffness that what comes next needs: bodies that fall or fly yet, and feet of stacks.
double needed_later(const Refused& refused, double allowed_share) {
    const std::optional<PredictedOverlap> next = largest_overlap(refused.model, refused.before, allowed_share);
    return next ? next->factor : 0;
}

}  // namespace

std::string stiffness_advice(const Refused& refused, double allowed_share) {
    const std::vector<contact::ShownContact> rows = shown_contacts(refused.model, refused.after, refused.scratch);
    const Deepest contact = find_deepest(refused, rows);
    if (!(contact.overlap > 0)) {
        return "";
    }
    Side side = side_of(refused, rows, contact.a, contact.b), other = side_of(refused, rows, contact.b, contact.a);
    const auto is_worse = [](const Side& x, const Side& y) {
        return x.is_held || x.driven.is_valid() || (!y.is_held && !y.driven.is_valid() && y.energy < x.energy);
    };
    if (is_worse(side, other)) {
        std::swap(side, other);
    }
    const bool has_no_room = side.is_backed && other.driven.is_valid();
    if (side.is_held || side.driven.is_valid() || has_no_room) {
        const BodyId driven = side.driven.is_valid() ? side.driven : other.driven;
        return driven.is_valid()
                   ? fmt::format("no stiffness holds '{}' up, which is driven: {} leaves its room to what it presses",
                                 refused.model.bodies.name(driven),
                                 assignment_below(fmt::format("body.{}.motion.stop", refused.model.bodies.name(driven)),
                                                  touched_at(refused, rows, driven)))
                   : "";
    }
    const double thin = std::min(thickness_of(refused.model, contact.a), thickness_of(refused.model, contact.b));
    const double allowed =
        allowed_share * (contact.is_of_faces ? thin : std::min(thin, sim::smallest_stand_in(refused.model)));
    const bool is_a = is_free(refused.model.bodies, contact.a, refused.after.time);
    const BodyId mover = is_a ? contact.a : contact.b, stop = is_a ? contact.b : contact.a;
    const double force = norm(contact.force);
    // Of a contact at a corner less than a face would hold; of a dashpot nothing.
    const auto energy_at = [&](double overlap) {
        const double found = 0.5 * force / contact.overlap * overlap * overlap;
        const double flat = force > 0 ? flat_contact_energy(refused.model, refused.after, mover, stop,
                                                            (is_a ? -1.0 : 1.0) * contact.force, overlap)
                                      : 0;
        return flat > 0 ? std::min(found, flat) : found;
    };
    const double brought =
        side.energy +
        side.mass * norm(refused.model.gravity.at(refused.after.time)) * std::max(0.0, allowed - contact.overlap) +
        energy_at(contact.overlap);
    const double holds = energy_at(allowed);
    if (!(holds > 0) || !std::isfinite(brought / holds)) {
        return "";
    }
    const double factor = reserve * std::max({1.0, brought / holds, needed_later(refused, allowed / thin)});
    return fmt::format("{} carries what '{}' brings",
                       stiffness_text(refused.model, contact.a, contact.b, contact.is_of_faces, factor),
                       refused.model.bodies.name(mover));
}

}  // namespace riprap::run
