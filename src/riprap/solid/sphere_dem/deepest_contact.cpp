// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/deepest_contact.hpp"

#include <algorithm>

#include "riprap/core/index.hpp"
#include "riprap/solid/sphere_dem/place.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Calls take(a, b, overlap [m], radius [m]) with the bodies of every contact and its smaller radius.
template <class Take>
void for_each_contact(const SphereModel& model, const SphereState& state, const SphereScratch& scratch,
                      const Take& take) {
    for (const std::uint64_t pair : state.contacts.pair) {
        const auto a = at(static_cast<std::int64_t>(pair >> 32)),
                   b = at(static_cast<std::int64_t>(pair & 0xffffffffULL));
        const SphereRecord &one = scratch.placed.records[a], &other = scratch.placed.records[b];
        const double apart = norm(Vec3{one.x - other.x, one.y - other.y, one.z - other.z});
        take(model.spheres.body[a], model.spheres.body[b], one.radius + other.radius - apart,
             std::min(one.radius, other.radius));
    }
    for (const WallContact& wall : scratch.walls) {
        take(model.spheres.body[at(wall.sphere)], wall_body(model, wall.wall), wall.overlap, wall.room);
    }
}

}  // namespace

DeepestContact deepest_contact(const SphereModel& model, const SphereState& state, const SphereScratch& scratch) {
    DeepestContact deepest;
    for_each_contact(model, state, scratch, [&](std::int32_t a, std::int32_t b, double overlap, double radius) {
        if (overlap / radius > deepest.share) {
            deepest = {BodyId{a}, BodyId{b}, overlap / radius};
        }
    });
    return deepest;
}

double largest_overlap(const SphereModel& model, const SphereState& state, const SphereScratch& scratch) {
    double largest = 0;
    for_each_contact(model, state, scratch,
                     [&](std::int32_t /*a*/, std::int32_t /*b*/, double overlap, double /*radius*/) {
                         largest = std::max(largest, overlap);
                     });
    return largest;
}

}  // namespace riprap::solid::sphere_dem
