// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/face_gauge.hpp"

#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {

namespace {

/// The face of a part that is nearest to a place in its frame, of those that carry a field and, in the plane, stand on
/// it.
struct NearFace {
    double distance{std::numeric_limits<double>::infinity()};
    Vec3 point{}, normal{};
};
NearFace nearest_face(const geometry::ConvexView& shape, const Vec3& x, bool is_planar) {
    NearFace nearest;
    for (std::int32_t j = 0; j < shape.face_count; ++j) {
        const Vec3 n = shape.normal(j);
        if (shape.is_internal[j] != 0 || (is_planar && std::abs(n.z) > 0.5)) {
            continue;
        }
        const Vec3 point =
            shape.vertex_count == 0 ? x + (shape.offset[j] - dot(n, x)) * n : nearest_on_face(shape, j, x);
        if (norm(x - point) < nearest.distance) {
            nearest = {norm(x - point), point, n};
        }
    }
    return nearest;
}

}  // namespace

Vec3 tangent(const Vec3& normal, bool is_planar) {
    return normalized(cross(normal, is_planar || std::abs(normal.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
}

std::optional<FaceGauge> find_face(const geometry::ShapeSet& shapes, const body::BodySet& bodies,
                                   const body::BodyState& initial, std::span<const std::uint8_t> is_dry,
                                   const Vec3& place, double reach, BodyId only) {
    std::optional<FaceGauge> found;
    double least = reach;
    for (const body::Part& part : bodies.parts) {
        const std::size_t b = at(part.body.value);
        if ((!is_dry.empty() && is_dry[b] != 0) || (only.is_valid() && part.body != only)) {
            continue;
        }
        const Pose placed{initial.position[b], initial.orientation[b]};
        const Pose pose{to_world(placed, part.local.position), placed.orientation * part.local.orientation};
        const NearFace face = nearest_face(shapes.view(part.shape), to_body(pose, place), bodies.is_planar);
        if (face.distance < least || (face.distance == least && !found)) {
            least = face.distance;
            found = {part.body, to_world(part.local, face.point), rotate(part.local.orientation, face.normal)};
        }
    }
    return found;
}

}  // namespace riprap::coupling
