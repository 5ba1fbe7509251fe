// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/deepest_contact.hpp"

#include <algorithm>

#include "riprap/core/index.hpp"
#include "riprap/solid/sphere_dem/place.hpp"

namespace riprap::solid::sphere_dem {

DeepestContact deepest_contact(const SphereModel& model, const SphereState& state, const SphereScratch& scratch) {
    DeepestContact deepest;
    const auto take = [&](std::int32_t a, std::int32_t b, double share) {
        if (share > deepest.share) {
            deepest = {BodyId{a}, BodyId{b}, share};
        }
    };
    for (const std::uint64_t pair : state.contacts.pair) {
        const auto a = at(static_cast<std::int64_t>(pair >> 32)),
                   b = at(static_cast<std::int64_t>(pair & 0xffffffffULL));
        const SphereRecord &one = scratch.placed.records[a], &other = scratch.placed.records[b];
        const double apart = norm(Vec3{one.x - other.x, one.y - other.y, one.z - other.z});
        take(model.spheres.body[a], model.spheres.body[b],
             (one.radius + other.radius - apart) / std::min(one.radius, other.radius));
    }
    for (const WallContact& wall : scratch.walls) {
        take(model.spheres.body[at(wall.sphere)], wall_body(model, wall.wall),
             wall.overlap / model.spheres.radius[at(wall.sphere)]);
    }
    return deepest;
}

}  // namespace riprap::solid::sphere_dem
