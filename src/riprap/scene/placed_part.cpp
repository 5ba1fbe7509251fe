// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/placed_part.hpp"

#include "riprap/geometry/convex_query.hpp"

namespace riprap::scene {

PlacedPart placed(const CaseBuild& build, const body::Part& part) {
    const auto b = static_cast<std::size_t>(part.body.value);
    const Pose body{build.state.bodies.position[b], build.state.bodies.orientation[b]};
    return {build.model.shapes.view(part.shape),
            {to_world(body, part.local.position), body.orientation * part.local.orientation}};
}

std::int32_t face_before(const PlacedPart& part, const Vec3& x, double distance) {
    const double reach = part.shape.circumradius + distance;
    if (norm_squared(x - part.pose.position) > reach * reach) {
        return -1;
    }
    const geometry::SurfacePoint near = geometry::closest_surface_point(part.shape, to_body(part.pose, x));
    const bool is_before = dot(near.normal, part.shape.normal(near.face)) > 1 - 1e-9;
    return near.distance > 0 && near.distance < distance && is_before ? near.face : -1;
}

BodyId solid_at(const CaseBuild& build, const std::vector<std::uint8_t>& is_dry, const Vec3& x, double depth) {
    for (const body::Part& part : build.model.bodies.parts) {
        const PlacedPart solid = placed(build, part);
        if (is_dry[static_cast<std::size_t>(part.body.value)] == 0 &&
            geometry::contains(solid.shape, to_body(solid.pose, x), -depth)) {
            return part.body;
        }
    }
    return {};
}

}  // namespace riprap::scene
