// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/case/placed_part.hpp"

#include "riprap/core/error.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

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

PlacedSolids::PlacedSolids(const CaseBuild& build, const std::vector<std::uint8_t>& is_dry, const Vec3& low,
                           const Vec3& high) {
    RIPRAP_ASSERT(is_dry.size() == static_cast<std::size_t>(build.model.bodies.size()), "is_dry is of all bodies");
    for (const body::Part& part : build.model.bodies.parts) {
        if (is_dry[static_cast<std::size_t>(part.body.value)] != 0) {
            continue;
        }
        const PlacedPart solid = placed(build, part);
        const Vec3& x = solid.pose.position;
        if (norm(x - max(low, min(high, x))) <= solid.shape.circumradius) {
            parts_.push_back(solid);
            bodies_.push_back(part.body);
        }
    }
}

BodyId PlacedSolids::at(const Vec3& x, double depth) const {
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const PlacedPart& solid = parts_[k];
        if (norm(x - solid.pose.position) <= solid.shape.circumradius &&
            geometry::contains(solid.shape, to_body(solid.pose, x), -depth)) {
            return bodies_[k];
        }
    }
    return {};
}

}  // namespace riprap::scene
