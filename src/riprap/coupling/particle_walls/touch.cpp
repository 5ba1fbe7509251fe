// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/touch.hpp"

#include <cmath>

#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {

namespace {

/// The part's, if it is nearer to a particle at one place than `within`.
std::optional<Touch> touch_at(const PlacedPart& part, const Vec3& x, double within) {
    if (norm_squared(x - part.pose.position) > part.reach * part.reach) {
        return std::nullopt;
    }
    const Vec3 local = to_body(part.pose, x);
    if (geometry::depth_below_faces(part.shape, local) <= -within) {
        return std::nullopt;
    }
    const geometry::SurfacePoint near = geometry::closest_surface_point(part.shape, local);
    if (near.distance >= within) {
        return std::nullopt;
    }
    return Touch{x, rotate(part.pose.orientation, near.normal), near.distance, 0.5 * within, part.body, false};
}

}  // namespace

std::optional<Touch> deepest_touch(const PlacedPart& part, const Vec3& x, double within,
                                   const fluid::PeriodicImages& images) {
    const Vec3 nearest = std::isfinite(part.reach) ? images.nearest(x, part.pose.position) : x;
    std::optional<Touch> deepest;
    for (const Vec3& shift : images.shifts()) {
        const std::optional<Touch> touch = touch_at(part, nearest + shift, within);
        if (touch && (!deepest || touch->distance < deepest->distance)) {
            deepest = touch;
        }
    }
    return deepest;
}

std::optional<Touch> touch_ground(const body::Ground& ground, const Pose& pose, const Vec3& x, double within,
                                  const fluid::PeriodicImages& images) {
    std::optional<Touch> deepest;
    for (const Vec3& shift : images.shifts()) {
        const auto near = ground.field.nearest(to_body(pose, x + shift), within);
        if (near && near->distance < within && (!deepest || near->distance < deepest->distance)) {
            deepest = Touch{x + shift,         rotate(pose.orientation, near->normal),
                            near->distance,    0.5 * within,
                            ground.body.value, true};
        }
    }
    return deepest;
}

}  // namespace riprap::coupling
