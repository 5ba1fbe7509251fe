// SPDX-License-Identifier: Apache-2.0
// Measures the room for water in regions, by cutting convex pieces.
#include <algorithm>
#include <cmath>

#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/scene/warnings/fluid_warnings.hpp"

namespace riprap::scene {

namespace {

using geometry::Plane;
using geometry::Polyhedron;

std::vector<Plane> planes_of(const Polyhedron& piece) {
    std::vector<Plane> planes;
    for (const auto& face : piece.faces) {
        planes.push_back(geometry::face_plane(piece.vertices, face));
    }
    return planes;
}

/// The planes of a part in world axes.
std::vector<Plane> planes_of(const geometry::ConvexView& shape, const Pose& pose) {
    std::vector<Plane> planes;
    for (std::int32_t j = 0; j < shape.face_count; ++j) {
        const Vec3 normal = rotate(pose.orientation, shape.normal(j));
        planes.push_back({normal, shape.offset[j] + dot(normal, pose.position)});
    }
    return planes;
}

/// Adds the part of `piece` outside of `planes` to `out`, as convex pieces that do not overlap.
void add_outside(Polyhedron piece, const std::vector<Plane>& planes, std::vector<Polyhedron>& out) {
    std::vector<Polyhedron> found;
    const Polyhedron whole = piece;
    for (const Plane& plane : planes) {
        geometry::CutPieces cut = geometry::cut_convex(piece, plane);
        if (!cut.above.faces.empty()) {
            found.push_back(std::move(cut.above));
        }
        piece = std::move(cut.below);
        if (piece.faces.empty()) {  // nothing is inside: no need to leave it in fragments
            out.push_back(whole);
            return;
        }
    }
    std::move(found.begin(), found.end(), std::back_inserter(out));
}

double volume_inside(Polyhedron piece, const std::vector<Plane>& planes) {
    for (const Plane& plane : planes) {
        piece = geometry::clip_convex(piece, plane);
        if (piece.faces.empty()) {
            return 0;
        }
    }
    return geometry::mass_properties(piece).volume;
}

/// Regions below their levels as convex pieces that do not overlap.
std::vector<Polyhedron> separate_pieces(const CaseBuild& build, const fluid::Domain& domain,
                                        const std::vector<coupling::FillRegion>& regions) {
    std::vector<Polyhedron> all;
    std::vector<std::vector<Plane>> earlier;
    for (const coupling::FillRegion& region : regions) {
        std::vector<Polyhedron> pieces = region.pieces;
        if (pieces.empty()) {
            Vec3 low = domain.low, high = domain.high;
            if (build.is_planar) {
                low.z = -0.5;
                high.z = 0.5;
            }
            pieces.push_back(geometry::moved(geometry::box(high - low), {0.5 * (low + high), {}}));
        }
        for (const Polyhedron& whole : pieces) {
            std::vector<Polyhedron> left{
                std::isfinite(region.level) ? geometry::clip_convex(whole, {build.up(), region.level}) : whole};
            if (left.front().faces.empty()) {
                continue;
            }
            std::vector<Plane> planes = planes_of(left.front());
            for (const std::vector<Plane>& taken : earlier) {
                std::vector<Polyhedron> next;
                for (Polyhedron& piece : left) {
                    add_outside(std::move(piece), taken, next);
                }
                left = std::move(next);
            }
            earlier.push_back(std::move(planes));
            std::move(left.begin(), left.end(), std::back_inserter(all));
        }
    }
    return all;
}

/// A box around a piece, for a quick no.
struct Bounds {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    explicit Bounds(const Polyhedron& piece) {
        for (const Vec3& x : piece.vertices) {
            low = min(low, x);
            high = max(high, x);
        }
    }
    bool is_near(const Vec3& center, double radius) const {
        const Vec3 nearest = max(low, min(center, high));
        return norm_squared(center - nearest) < radius * radius;
    }
};

}  // namespace

double room_for_water(const CaseBuild& build, const fluid::Domain& domain,
                      const std::vector<coupling::FillRegion>& regions) {
    std::vector<std::pair<geometry::ConvexView, Pose>> blocks;
    std::vector<Plane> grounds;
    for (const body::Part& part : build.model.bodies.parts) {
        const auto b = static_cast<std::size_t>(part.body.value);
        const Pose body{build.state.bodies.position[b], build.state.bodies.orientation[b]};
        const Pose pose{to_world(body, part.local.position), body.orientation * part.local.orientation};
        const geometry::ConvexView shape = build.model.shapes.view(part.shape);
        if (shape.vertex_count > 0) {
            blocks.emplace_back(shape, pose);
        } else {
            grounds.push_back(planes_of(shape, pose).front());
        }
    }
    double room = 0;
    for (Polyhedron& piece : separate_pieces(build, domain, regions)) {
        for (const Plane& ground : grounds) {
            piece = geometry::clip_convex(piece, {-1.0 * ground.normal, -ground.offset});
        }
        if (piece.faces.empty()) {
            continue;
        }
        double volume = geometry::mass_properties(piece).volume;
        const Bounds bounds(piece);
        for (const auto& [shape, pose] : blocks) {
            if (bounds.is_near(pose.position, shape.circumradius)) {
                volume -= volume_inside(piece, planes_of(shape, pose));
            }
        }
        room += volume;
    }
    return room;  // planar pieces are one metre thick
}

}  // namespace riprap::scene
