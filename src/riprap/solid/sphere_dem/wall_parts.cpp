// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/wall_parts.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/contact/narrowphase/sphere_triangle.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/sphere_dem/way_out.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// A step up to this share of the radius between two parts is none [-].
constexpr double step_share = 1e-3;
/// Cosine of the angle between contacts at two edges up to which they are one edge, 3 degrees.
constexpr double same_edge = 0.99863;

geometry::ConvexView shape_of(const SphereModel& model, std::int32_t part) {
    return model.shapes.view(model.bodies.parts[at(part)].shape);
}

/// Depth of a point below the surface of a part, exact inside and at most the distance outside [m].
double depth_in(const SphereModel& model, const Placed& placed, std::int32_t part, const Vec3& x) {
    const contact::Frame& frame = placed.part_frame[at(part)];
    return geometry::depth_below_faces(shape_of(model, part), transpose_times(frame.axes, x - frame.origin));
}

/// Puts the contact on the next way out where the centre is inside the part, behind a face that is covered.
/// @returns false where it is outside: the part that covers the face holds the sphere
bool take_next_way_out(const SphereModel& model, const Placed& placed, Touched& one) {
    const Vec3& centre = placed.center[at(one.contact.sphere)];
    const double radius = placed.radius[at(one.contact.sphere)];
    if (one.contact.overlap < radius) {
        return false;
    }
    const geometry::ConvexView shape = shape_of(model, one.contact.wall);
    const contact::Frame& frame = placed.part_frame[at(one.contact.wall)];
    const WayOut next = next_way_out(shape, transpose_times(frame.axes, centre - frame.origin), one.face);
    const Vec3 outward = frame.axes * shape.normal(next.face);
    one.contact.normal = -outward;
    one.contact.point = centre + next.depth * outward;
    one.contact.overlap = radius + next.depth;
    one.face = next.face;
    return true;
}

/// Puts the contact between the ways out that are equally short where the centre is inside the part.
void take_middle_way_out(const geometry::ConvexView& shape, const contact::Frame& frame, const Vec3& centre,
                         Touched& one) {
    const MiddleWay way = middle_way_out(shape, transpose_times(frame.axes, centre - frame.origin), one.face);
    if (way.length > 0) {
        const Vec3 outward = frame.axes * way.outward;
        const double depth = dot(one.contact.normal, centre - one.contact.point);
        one.contact.normal = -outward;
        one.contact.point = centre + way.length * outward;
        one.contact.overlap += way.length - depth;
        one.face = -1;
    }
}

/// Does another part hide an edge or corner? One does whose face the sphere stands on, where the edge does not rise
/// above that face by more than a step: the next face continues it. Of the edges of two parts with a narrow joint
/// between, the nearer one counts, so that the spring of the sphere has one overlap all the way.
bool is_hidden(const Touched& edge, const Touched& other, double step) {
    const Vec3 up = -other.contact.normal;
    if (dot(up, edge.contact.point - other.contact.point) > step) {
        return false;
    }
    if (other.face >= 0) {
        return dot(other.contact.normal, edge.contact.normal) > 0;
    }
    const bool is_nearer = other.contact.overlap > edge.contact.overlap ||
                           (other.contact.overlap == edge.contact.overlap && other.contact.wall < edge.contact.wall);
    return is_nearer && dot(other.contact.normal, edge.contact.normal) > same_edge;
}

/// Tells whether a face is no way out: where it meets the sphere another part that the sphere touches lies behind it,
/// and where the next way out leads as well. So it is with the sides of blocks that lie flush, and with those of two
/// blocks that meet in the bottom of a notch; the side of a step stands free above the lower block.
bool is_covered(const SphereModel& model, const Placed& placed, const Touched& one, const Touched& other, double step) {
    if (one.face < 0 || other.contact.wall == one.contact.wall ||
        depth_in(model, placed, other.contact.wall, one.contact.point) < -step) {
        return false;
    }
    const geometry::ConvexView shape = shape_of(model, one.contact.wall);
    const contact::Frame& frame = placed.part_frame[at(one.contact.wall)];
    const Vec3 local = transpose_times(frame.axes, one.contact.point - frame.origin);
    const WayOut next = next_way_out(shape, local, one.face);
    return next.face >= 0 && depth_in(model, placed, other.contact.wall,
                                      one.contact.point + next.depth * (frame.axes * shape.normal(next.face))) >= -step;
}

/// Puts the contact on the next way out from where another part lets the sphere out. In the notch of two parts a small
/// sphere whose centre comes into one of them through its side would else lose the other one under it, with all that
/// its spring holds.
/// @returns false where that way is none: the other part's own contact is all
bool take_way_out_of_notch(const SphereModel& model, const Placed& placed, Touched& one, const Touched& other) {
    const double radius = placed.radius[at(one.contact.sphere)];
    if (other.face < 0 || other.contact.overlap < radius) {
        return false;
    }
    const geometry::ConvexView shape = shape_of(model, one.contact.wall);
    const contact::Frame& frame = placed.part_frame[at(one.contact.wall)];
    const WayOut next = next_way_out(shape, transpose_times(frame.axes, other.contact.point - frame.origin), one.face);
    if (next.face < 0 || next.depth <= -radius) {
        return false;
    }
    const Vec3 outward = frame.axes * shape.normal(next.face);
    one.contact.normal = -outward;
    one.contact.point = other.contact.point + next.depth * outward;
    one.contact.overlap = radius + next.depth;
    one.face = next.face;
    return true;
}

/// The face of a part that lies against the face by which another part lets the sphere out; -1 where none does.
std::int32_t face_against(const SphereModel& model, const Placed& placed, const Touched& one, const Touched& other,
                          double step) {
    const double radius = placed.radius[at(one.contact.sphere)];
    if (other.face < 0 || other.contact.wall == one.contact.wall || other.contact.overlap < radius) {
        return -1;
    }
    const geometry::ConvexView shape = shape_of(model, one.contact.wall);
    const contact::Frame& frame = placed.part_frame[at(one.contact.wall)];
    const Vec3 into = transpose_times(frame.axes, other.contact.normal);
    const Vec3 local = transpose_times(frame.axes, other.contact.point - frame.origin);
    for (std::int32_t f = 0; f < shape.face_count; ++f) {
        const double depth = shape.offset[f] - dot(shape.normal(f), local);
        if (dot(shape.normal(f), into) > same_edge && std::abs(depth) <= step) {
            return f;
        }
    }
    return -1;
}

/// Looks for a part that holds the sphere in the notch that it makes with `one`, and puts the contact there.
bool take_notch_of_any(const SphereModel& model, const Placed& placed, Touched& one,
                       const std::vector<Touched>& touched, double step) {
    for (const Touched& other : touched) {
        if (const std::int32_t face = face_against(model, placed, one, other, step); face >= 0) {
            one.face = face;
            return take_way_out_of_notch(model, placed, one, other);
        }
    }
    return false;
}

}  // namespace

Touched touch(const SphereModel& model, const Placed& placed, const contact::PartPair pair) {
    const geometry::ConvexView shape = shape_of(model, pair.b);
    const contact::Frame& frame = placed.part_frame[at(pair.b)];
    const contact::SphereTouch found =
        contact::touch_convex(shape, frame, placed.center[at(pair.a)], placed.radius[at(pair.a)]);
    const Vec3 outward = -transpose_times(frame.axes, found.normal);
    std::int32_t face = -1;
    for (std::int32_t f = 0; f < shape.face_count && face < 0; ++f) {
        face = norm_squared(shape.normal(f) - outward) < 1e-18 ? f : -1;
    }
    Touched touched{{pair.a, pair.b, found.normal, found.point, found.overlap, 1, 0, portion_of(model, pair.a)}, face};
    if (face >= 0 && shape.is_internal[face] != 0) {
        take_next_way_out(model, placed, touched);  // none leads through the end of a prism or into the next part
    }
    if (touched.face >= 0 && touched.contact.overlap > placed.radius[at(pair.a)]) {
        take_middle_way_out(shape, frame, placed.center[at(pair.a)], touched);
    }
    // A sharp sample is so small that its centre may come into a part: there it has to stop before the far side is
    // near.
    const double own = model.spheres.curvature[at(pair.a)];
    const double room = model.spheres.is_sharp(pair.a) ? std::min(own, 2 * shape.inscribed_radius) : own;
    touched.contact.room = room;
    return touched;
}

void add_parts(const SphereModel& model, const Placed& placed, const std::vector<Touched>& touched,
               std::vector<WallContact>& out) {
    if (touched.size() == 1) {
        out.push_back(touched.front().contact);
        return;
    }
    for (Touched one : touched) {
        const double step = step_share * model.spheres.curvature[at(one.contact.sphere)];
        if (one.contact.overlap < placed.radius[at(one.contact.sphere)] &&
            take_notch_of_any(model, placed, one, touched, step)) {
            out.push_back(one.contact);
            continue;
        }
        const auto hides = [&](const Touched& other) {
            return one.face < 0 && other.contact.wall != one.contact.wall && is_hidden(one, other, step);
        };
        const auto covers = [&](const Touched& other) { return is_covered(model, placed, one, other, step); };
        if (!std::ranges::any_of(touched, hides) &&
            (std::ranges::none_of(touched, covers) || take_next_way_out(model, placed, one))) {
            out.push_back(one.contact);
        }
    }
}

void add_missed(const SphereModel& model, const Placed& placed, const std::vector<Touched>& touched,
                const std::vector<Touched>& missed, std::vector<WallContact>& out) {
    for (Touched one : missed) {
        const double step = step_share * model.spheres.curvature[at(one.contact.sphere)];
        if (take_notch_of_any(model, placed, one, touched, step)) {
            out.push_back(one.contact);
        }
    }
}

}  // namespace riprap::solid::sphere_dem
