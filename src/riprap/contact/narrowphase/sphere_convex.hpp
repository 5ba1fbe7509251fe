// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/frame.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::contact {

/// Nearest point of a surface to the centre of a sphere.
struct SphereTouch {
    Vec3 normal;  ///< unit vector from the sphere into the surface [-]
    Vec3 point;   ///< of the surface, nearest to the centre [m]
    /// Radius less the distance; more than the radius where the centre is inside. Where it is not positive it is no
    /// less than that, and nothing else is set [m].
    double overlap;
};

/// Sphere against a convex polyhedron or half-space: face, edge or corner, whichever is nearest. One contact, whose
/// normal turns smoothly as the sphere rolls over an edge.
inline SphereTouch touch_convex(const geometry::ConvexView& shape, const Frame& frame, const Vec3& centre,
                                double radius) {
    const Vec3 local = transpose_times(frame.axes, centre - frame.origin);
    if (const double depth = depth_below_faces(shape, local); depth <= -radius) {
        return {{}, {}, radius + depth};  // beyond a face by more than its radius: most candidates are
    }
    const geometry::SurfacePoint nearest = geometry::closest_surface_point(shape, local);
    return {-(frame.axes * nearest.normal), frame.origin + frame.axes * nearest.point, radius - nearest.distance};
}

}  // namespace riprap::contact
