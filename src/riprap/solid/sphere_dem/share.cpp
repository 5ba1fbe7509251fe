// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/share.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/sphere_dem/place.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Sorts contacts by their pair of bodies, and gives each contact its share.
/// @param overlap     per contact [m]
/// @param portion_of  portion_of(contact), by which its springs count [-]
/// @param set         set(contact, weight)
template <class Portion, class Set>
void share_groups(contact::Sharing sharing, const std::vector<double>& overlap, const Portion& portion_of,
                  SphereScratch& scratch, const Set& set) {
    parallel::sort_by_key(scratch.group_key, scratch.group_contact, scratch.group_key_scratch,
                          scratch.group_contact_scratch);
    const std::size_t count = scratch.group_key.size();
    for (std::size_t first = 0, last = 0; first < count; first = last) {
        double sum = 0, squares = 0, largest = 0;
        std::size_t deepest = first;
        for (last = first; last < count && scratch.group_key[last] == scratch.group_key[first]; ++last) {
            const double depth = overlap[scratch.group_contact[last]];
            const double portion = portion_of(scratch.group_contact[last]);
            sum += portion * depth;
            squares += portion * depth * depth;
            if (depth > largest) {
                largest = depth;
                deepest = last;
            }
        }
        // Divided springs do no work that depends on the way only where 1/N does not change as the bodies tilt a
        // little: to first order the deepest contact does, the sum of the squares does not.
        const bool divides = sharing == contact::Sharing::divide;
        const double share = !(sum > 0) ? 1 : divides ? squares / (sum * sum) : largest / sum;
        for (std::size_t k = first; k < last; ++k) {
            set(scratch.group_contact[k], sharing == contact::Sharing::dashpots ? std::sqrt(share)
                                          : sharing == contact::Sharing::divide ? share
                                          : k == deepest                        ? 1.0
                                                                                : 0.0);
        }
    }
}

std::uint64_t body_key(std::int32_t a, std::int32_t b) {
    return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b);
}

/// The part of a body that has only one, else -1.
std::int32_t only_part(const body::BodySet& bodies, std::int32_t body) {
    const std::int32_t begin = bodies.part_begin[at(body)];
    return bodies.part_begin[at(body) + 1] == begin + 1 ? begin : -1;
}

void share_spheres(const SphereModel& model, const SphereState& state, SphereScratch& scratch) {
    const std::size_t count = state.contacts.size();
    scratch.weight.assign(count, 1);
    scratch.overlap.resize(count);
    scratch.group_key.clear();
    scratch.group_contact.clear();
    for (std::size_t c = 0; c < count; ++c) {
        const auto a = at(static_cast<std::int64_t>(state.contacts.pair[c] >> 32)),
                   b = at(static_cast<std::int64_t>(state.contacts.pair[c] & 0xFFFFFFFF));
        const std::int32_t body_a = model.spheres.body[a], body_b = model.spheres.body[b];
        if (model.spheres.count_of(body_a) > 1 || model.spheres.count_of(body_b) > 1) {
            scratch.overlap[c] = model.spheres.radius[a] + model.spheres.radius[b] -
                                 norm(scratch.placed.center[b] - scratch.placed.center[a]);
            scratch.group_key.push_back(body_key(body_a, body_b));
            scratch.group_contact.push_back(static_cast<std::uint32_t>(c));
        }
    }
    const auto whole = [](std::uint32_t /*contact*/) { return 1.0; };
    share_groups(model.settings.sharing, scratch.overlap, whole, scratch,
                 [&](std::uint32_t c, double weight) { scratch.weight[c] = weight; });
}

void share_walls(const SphereModel& model, SphereScratch& scratch) {
    scratch.group_key.clear();
    scratch.group_contact.clear();
    scratch.overlap.resize(std::max(scratch.overlap.size(), scratch.walls.size()));
    const std::int32_t parts = model.bodies.part_count();
    for (std::size_t c = 0; c < scratch.walls.size(); ++c) {
        const WallContact& contact = scratch.walls[c];
        const std::int32_t body = model.spheres.body[at(contact.sphere)];
        if (model.spheres.count_of(body) > 1) {
            // Each part counts as a body of its own, so floor and wall of one tank are two; all triangles of a surface
            // count as one. Where the edges of two bodies of one part meet the other's faces, all of them are one
            // group.
            std::int32_t first = body,
                         second = contact.wall < parts ? contact.wall : parts + wall_body(model, contact.wall);
            if (const std::int32_t own = only_part(model.bodies, body);
                own >= 0 && contact.wall < parts && only_part(model.bodies, wall_body(model, contact.wall)) >= 0) {
                first = std::min(own, contact.wall);
                second = std::max(own, contact.wall);
            }
            scratch.overlap[c] = contact.overlap;
            scratch.group_key.push_back(body_key(first, second));
            scratch.group_contact.push_back(static_cast<std::uint32_t>(c));
        }
    }
    share_groups(
        model.settings.sharing, scratch.overlap, [&](std::uint32_t c) { return scratch.walls[c].portion; }, scratch,
        [&](std::uint32_t c, double weight) { scratch.walls[c].weight = weight; });
}

}  // namespace

void share_contacts(const SphereModel& model, const SphereState& state, SphereScratch& scratch) {
    scratch.weight.clear();
    if (model.spheres.has_clusters && model.settings.sharing != contact::Sharing::sum) {
        share_spheres(model, state, scratch);
        share_walls(model, scratch);
    }
}

}  // namespace riprap::solid::sphere_dem
