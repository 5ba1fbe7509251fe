// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/common_plane_physics.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/contact/find_contacts.hpp"
#include "riprap/contact/narrowphase/common_plane_contacts.hpp"
#include "riprap/contact/narrowphase/plane_section.hpp"
#include "riprap/contact/respond.hpp"
#include "riprap/contact/round_push.hpp"

namespace riprap::contact {

namespace {

/// Corners and normals of one side, in world axes.
struct Placed {
    std::vector<Vec3> vertices, normals;

    PlacedHull place(const PairSide& side, const HullTopology& topology) {
        const geometry::ConvexView& shape = side.shape;
        vertices.resize(at(shape.vertex_count));
        normals.resize(at(shape.face_count));
        for (int v = 0; v < shape.vertex_count; ++v) {
            vertices[at(v)] = side.frame.origin + side.frame.axes * shape.vertex(v);
        }
        for (int f = 0; f < shape.face_count; ++f) {
            normals[at(f)] = side.frame.axes * shape.normal(f);
        }
        const double offset = shape.vertex_count == 0 ? shape.offset[0] + dot(normals[0], side.frame.origin) : 0;
        return {&topology, vertices, normals, side.frame.origin, offset};
    }
};

/// Farthest reach of a side along a world direction.
double reach_along(const PairSide& side, const Vec3& direction) {
    const Vec3 local = transpose_times(side.frame.axes, direction);
    double most = -1e300;
    for (int v = 0; v < side.shape.vertex_count; ++v) {
        most = std::max(most, dot(local, side.shape.vertex(v)));
    }
    return dot(direction, side.frame.origin) + most;
}

/// Does the direction that parted the pair before still do so?
bool is_still_apart(const PairSide& a, const PairSide& b, const SeparatingCache& cache) {
    const Vec3 n = a.frame.axes * Vec3{cache.x, cache.y, cache.z};
    return a.shape.vertex_count > 0 && b.shape.vertex_count > 0 && norm_squared(n) > 0 &&
           -reach_along(b, -n) - reach_along(a, n) > 0;
}

/// Stiffness over area of both sides in parallel with their fields, as in conventions.md [Pa/m].
double stiffness_per_area(const PairSide& a, const PairSide& b) {
    return a.material.normal_stiffness / a.shape.inscribed_radius +
           b.material.normal_stiffness / b.shape.inscribed_radius;
}

/// Area under a spring that depends on how deep it is pressed: A(d) now, and `stored`, the mean that gives its energy,
/// int_0^d A(s) s ds = stored d^2/2 [m^2].
struct SpringArea {
    double now{0}, stored{0};
};

/// What edges and corners stand for that meet without a face: the section common to both bodies, an equal share a
/// point. It grows with d^2 where edges cross, with d where an edge lies on a face; Simpson's rule is exact for both.
SpringArea area_of_section(const PlacedHull& a, const PlacedHull& b, const CommonPlane& plane, int count) {
    const double now = common_section(a, b, plane.normal, -plane.gap);
    const double before = common_section(a, b, plane.normal, -0.5 * plane.gap);
    return {now / count, (2 * before + now) / 3 / count};
}

/// Fills the contact of a pair of which one side is a ball or a disc. @returns false where they do not overlap
bool find_round(const RoundPush& round, PlaneLaw law, double per_area, double radius, bool is_planar,
                NormalContact& normal, Vec3& n) {
    if (law == PlaneLaw::soft) {
        return round.push(normal, n);
    }
    if (!round.overlaps(normal, n)) {
        return false;
    }
    normal.stiffness = (is_planar ? 2 : 1) * per_area * radius * radius;  // a prism has a point at either end
    normal.force = -normal.stiffness * normal.depth * n;
    normal.energy = 0.5 * normal.stiffness * normal.depth * normal.depth;
    normal.potential = normal.depth / radius;
    return true;
}

}  // namespace

std::vector<HullTopology> hull_topologies(const geometry::ShapeSet& shapes) {
    std::vector<HullTopology> topologies(at(shapes.size()));
    for (std::int32_t s = 0; s < shapes.size(); ++s) {
        if (!shapes.is_half_space(ShapeId{s})) {
            topologies[at(s)] = hull_topology(shapes.polyhedron(ShapeId{s}));
        }
    }
    return topologies;
}

void CommonPlanePhysics::meet(const Candidate& pair, SeparatingCache& cache, FoundContacts& found) const {
    const PairSide &a = pair.a, &b = pair.b;
    if (is_still_apart(a, b, cache)) {
        return;
    }
    const PlacedShape at_a{a.shape, a.frame}, at_b{b.shape, b.frame};
    const RoundPush round(at_a, a.material.normal_stiffness, at_b, b.material.normal_stiffness);
    if (round.is_round()) {
        const double least = std::min(a.shape.inscribed_radius, b.shape.inscribed_radius);
        const bool is_planar = a.shape.is_planar || b.shape.is_planar;
        NormalContact normal{};
        if (Vec3 n; find_round(round, law, stiffness_per_area(a, b), least, is_planar, normal, n)) {
            respond(pair, normal, n, feature_key(0, 0), friction, found);
        }
        return;
    }
    thread_local Placed placed_a, placed_b;
    const auto topology = [this](const PairSide& side) -> const HullTopology& {
        return topologies[at(bodies.parts[at(side.part)].shape.value)];
    };
    const PlacedHull hull_a = placed_a.place(a, topology(a)), hull_b = placed_b.place(b, topology(b));
    const CommonPlane plane = common_plane_near(hull_a, hull_b, found.old_normal(), 0);
    if (plane.gap > 0) {
        const Vec3 n = transpose_times(a.frame.axes, plane.normal);
        cache = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
        return;
    }
    PlaneContacts points;
    find_plane_contacts(hull_a, hull_b, plane, contact_tolerance(hull_a, hull_b, plane), points);
    const double radius = std::min(a.shape.inscribed_radius, b.shape.inscribed_radius), square = radius * radius;
    const bool by_section = law == PlaneLaw::soft && points.count > 0 && !(points.area > 0);
    const SpringArea section = by_section ? area_of_section(hull_a, hull_b, plane, points.count) : SpringArea{};
    for (int k = 0; k < points.count; ++k) {
        const PlaneContact& point = points.contacts[at(k)];
        if (point.gap >= 0) {
            continue;
        }
        const double depth = -point.gap, own = law == PlaneLaw::penalty ? square : point.area + 0.01 * square;
        const SpringArea area{own + section.now, own + section.stored};
        NormalContact normal{};
        normal.stiffness = area.now * stiffness_per_area(a, b);
        normal.force = -normal.stiffness * depth * points.normal;
        normal.point = 0.5 * (point.on_a + point.on_b);
        normal.area = point.area;
        normal.energy = 0.5 * area.stored * stiffness_per_area(a, b) * depth * depth;
        normal.depth = depth;
        normal.potential = depth / radius;
        normal.spin_moment = 2.0 / 3 * norm(normal.force) * std::sqrt(point.area / M_PI);
        respond(pair, normal, points.normal, point.feature, friction, found);
    }
}

template double ContactPipeline::find_contacts(const CommonPlanePhysics& physics, const ContactScene& scene,
                                               const body::BodyState& state, const body::BodyKinematics& kinematics,
                                               double sliding_time, ContactHistory& history);

}  // namespace riprap::contact
