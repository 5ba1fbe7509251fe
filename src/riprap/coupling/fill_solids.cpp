// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/fill_solids.hpp"

#include <algorithm>

#include "riprap/geometry/convex_query.hpp"

namespace riprap::coupling {

FillSolids::FillSolids(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state)
    : grounds_(body::find_grounds(bodies, shapes)) {
    const auto at = [](BodyId body) { return static_cast<std::size_t>(body.value); };
    std::vector<std::uint8_t> is_ground(static_cast<std::size_t>(bodies.size()), 0);
    for (const body::Ground& ground : grounds_) {
        const std::size_t b = at(ground.body);
        is_ground[b] = 1;
        poses_.push_back({state.position[b], state.orientation[b]});
    }
    for (const body::Part& part : bodies.parts) {
        const std::size_t b = at(part.body);
        if (is_ground[b] != 0) {
            continue;
        }
        const Pose pose{state.position[b], state.orientation[b]};
        parts_.push_back({shapes.view(part.shape),
                          {to_world(pose, part.local.position), pose.orientation * part.local.orientation}});
    }
}

bool FillSolids::contain(const Vec3& x) const {
    for (std::size_t g = 0; g < grounds_.size(); ++g) {
        if (grounds_[g].field.is_inside(to_body(poses_[g], x))) {
            return true;
        }
    }
    return std::any_of(parts_.begin(), parts_.end(), [&](const Placed& part) {
        return norm_squared(x - part.pose.position) <= part.shape.circumradius * part.shape.circumradius &&
               geometry::contains(part.shape, to_body(part.pose, x));
    });
}

bool FillSolids::are_near(const Vec3& x, double distance) const {
    for (std::size_t g = 0; g < grounds_.size(); ++g) {
        const Vec3 local = to_body(poses_[g], x);
        if (grounds_[g].field.is_inside(local) || grounds_[g].field.nearest(local, distance)) {
            return true;
        }
    }
    return std::any_of(parts_.begin(), parts_.end(), [&](const Placed& part) {
        const double reach = part.shape.circumradius + distance;
        if (norm_squared(x - part.pose.position) > reach * reach) {
            return false;
        }
        const Vec3 local = to_body(part.pose, x);
        return geometry::depth_below_faces(part.shape, local) > -distance &&
               geometry::closest_surface_point(part.shape, local).distance < distance;
    });
}

}  // namespace riprap::coupling
