// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/foot_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"

namespace riprap::contact {

namespace {

using geometry::ConvexView;
using Corners = std::vector<PatchCorner>;

/// Corners count as inside of an edge up to this share of the pair's size, so that edges that lie on each other to
/// round-off do not cross.
constexpr double relative_slack = 1e-9;

double cross(const PatchPoint& a, const PatchPoint& b) { return a.x * b.y - a.y * b.x; }
double dot(const PatchPoint& a, const PatchPoint& b) { return a.x * b.x + a.y * b.y; }

bool lies_in_internal_face(const ConvexView& shape, int from, int to) {
    for (int f = 0; f < shape.face_count; ++f) {
        if (shape.is_internal[f] == 0) {
            continue;
        }
        const std::int32_t *begin = shape.face_vertex + shape.face_start[f],
                           *end = shape.face_vertex + shape.face_start[f + 1];
        if (std::find(begin, end, from) != end && std::find(begin, end, to) != end) {
            return true;
        }
    }
    return false;
}

bool has_internal_face(const ConvexView& shape) {
    return std::any_of(shape.is_internal, shape.is_internal + shape.face_count, [](auto is) { return is != 0; });
}

/// Adds the edges of a face as the patch sees them, counter-clockwise about n: A is seen from outside, B from inside;
/// and their first ends.
void add_outline(const PlacedShape& part, int face, bool is_of_b, const FacingFaces& faces, FootPatch& patch,
                 Corners& corners) {
    const ConvexView& shape = part.shape;
    const int begin = shape.face_start[face], count = shape.face_start[face + 1] - begin;
    const auto vertex = [&](int k) { return shape.face_vertex[begin + (is_of_b ? count - 1 - k : k)]; };
    const auto place = [&](int k) { return part.frame.axes * shape.vertex(vertex(k)); };
    const bool has_internal = has_internal_face(shape);
    const Vec3 shift = part.frame.origin - faces.origin;
    Vec3 here = place(0);
    for (int k = 0; k < count; ++k) {
        const int next = k + 1 < count ? k + 1 : 0;
        const Vec3 there = place(next), whole = there - here;
        const PatchPoint flat{riprap::dot(whole, patch.e1), riprap::dot(whole, patch.e2)};
        const double length = std::sqrt(dot(flat, flat));
        PatchCorner corner;
        corner.place = {riprap::dot(shift + here, patch.e1), riprap::dot(shift + here, patch.e2)};
        corner.edge = static_cast<int>(patch.edges.size());
        corners.push_back(corner);
        patch.edges.push_back({is_of_b,
                               !has_internal || !lies_in_internal_face(shape, vertex(k), vertex(next)),
                               {flat.x / length, flat.y / length},
                               whole});
        here = there;
    }
}

/// Keeps the part of an outline to the left of an edge [Sutherland1974].
void cut(const Corners& in, const PatchPoint& from, const PatchPoint& along, int edge, double slack, Corners& out) {
    out.clear();
    const auto left = [&](const PatchPoint& p) { return cross(along, {p.x - from.x, p.y - from.y}); };
    double l0 = left(in.empty() ? from : in[0].place);
    const double first = l0;
    for (std::size_t i = 0; i < in.size(); ++i) {
        const bool is_last = i + 1 == in.size();
        const PatchCorner &here = in[i], &next = in[is_last ? 0 : i + 1];
        const double l1 = is_last ? first : left(next.place);
        const bool is_in = l0 >= -slack;
        if (is_in) {
            out.push_back(here);
        }
        if (is_in != (l1 >= -slack)) {
            const double t = std::clamp(l0 / (l0 - l1), 0.0, 1.0);
            PatchCorner corner;
            corner.place = {here.place.x + t * (next.place.x - here.place.x),
                            here.place.y + t * (next.place.y - here.place.y)};
            corner.edge = is_in ? edge : here.edge;
            out.push_back(corner);
        }
        l0 = l1;
    }
}

void measure(FootPatch& patch) {
    const PatchPoint& o = patch.corners[0].place;
    double twice = 0;
    PatchPoint first;
    patch.free_length = 0;
    for (std::size_t i = 0; i < patch.size(); ++i) {
        PatchCorner& corner = patch.corners[i];
        const PatchPoint here = corner.place, there = patch.next(i).place;
        const PatchPoint in = patch.edge_from(patch.last(i)).along, out = patch.edge_from(corner).along;
        const PatchPoint p{here.x - o.x, here.y - o.y}, q{there.x - o.x, there.y - o.y};
        const double part = cross(p, q);
        twice += part;
        first = {first.x + part * (p.x + q.x), first.y + part * (p.y + q.y)};
        corner.turn = std::atan2(cross(in, out), dot(in, out));
        patch.free_length += patch.edge_from(corner).is_free ? dot(out, {there.x - here.x, there.y - here.y}) : 0;
    }
    patch.area = 0.5 * twice;
    patch.centroid = {o.x + first.x / (3 * twice), o.y + first.y / (3 * twice)};
}

/// A point of the plane of a face, from the origin of the pair.
Vec3 point_of(const PlacedShape& part, int face, const Vec3& origin) {
    const ConvexView& shape = part.shape;
    return (part.frame.origin - origin) +
           part.frame.axes * (part.is_plane() ? shape.offset[face] * shape.normal(face)
                                              : shape.vertex(shape.face_vertex[shape.face_start[face]]));
}

}  // namespace

double FootPatch::width() const {
    return free_length > 0 ? 2 * area / free_length : std::numeric_limits<double>::infinity();
}

bool find_foot_patch(const PlacedShape& a, const PlacedShape& b, const FacingFaces& faces, FootPatch& patch) {
    patch.n = normalized(faces.normal_a - faces.normal_b);
    const PlacedShape& solid = a.is_plane() ? b : a;
    const int face = a.is_plane() ? faces.of_b : faces.of_a;
    const std::int32_t* loop = solid.shape.face_vertex + solid.shape.face_start[face];
    const Vec3 first = solid.frame.axes * (solid.shape.vertex(loop[1]) - solid.shape.vertex(loop[0]));
    patch.e1 = normalized(first - riprap::dot(first, patch.n) * patch.n);
    patch.e2 = riprap::cross(patch.n, patch.e1);

    patch.edges.clear();
    patch.corners.clear();
    add_outline(solid, face, a.is_plane(), faces, patch, patch.corners);
    if (!a.is_plane() && !b.is_plane()) {
        static thread_local Corners of_b, next;
        of_b.clear();
        add_outline(b, faces.of_b, true, faces, patch, of_b);
        const double slack = relative_slack * (a.shape.circumradius + b.shape.circumradius);
        for (const PatchCorner& corner : of_b) {
            cut(patch.corners, corner.place, patch.edge_from(corner).along, corner.edge, slack, next);
            std::swap(patch.corners, next);
        }
    }
    if (patch.size() < 3) {
        return false;
    }
    measure(patch);
    if (!(patch.area > 0)) {
        return false;
    }
    const auto slope = [&](const Vec3& m) {
        const double upright = riprap::dot(m, patch.n);
        return PatchPoint{-riprap::dot(m, patch.e1) / upright, -riprap::dot(m, patch.e2) / upright};
    };
    patch.slope_a = slope(faces.normal_a);
    patch.slope_b = slope(faces.normal_b);
    const Vec3 base_a = point_of(a, faces.of_a, faces.origin), base_b = point_of(b, faces.of_b, faces.origin);
    const auto lift = [&](const PatchPoint& q, const Vec3& base, const PatchPoint& tilt) {
        const double x = q.x - riprap::dot(base, patch.e1), y = q.y - riprap::dot(base, patch.e2);
        return base + x * patch.e1 + y * patch.e2 + (tilt.x * x + tilt.y * y) * patch.n;
    };
    for (PatchCorner& corner : patch.corners) {
        corner.on_a = lift(corner.place, base_a, patch.slope_a);
        corner.on_b = lift(corner.place, base_b, patch.slope_b);
        corner.depth = riprap::dot(corner.on_a - corner.on_b, patch.n);
    }
    return true;
}

ClosedPatch closed_part(const FootPatch& patch) {
    double area = 0, push = 0, x = 0, y = 0;
    struct Point {
        PatchPoint place;
        double depth;
    };
    Point first{}, before{};
    int count = 0;
    // Triangles about the first point; pressure is linear in each.
    const auto add = [&](const Point& p) {
        if (count++ == 0) {
            first = p;
        } else if (count > 2) {
            const PatchPoint u{before.place.x - first.place.x, before.place.y - first.place.y};
            const PatchPoint v{p.place.x - first.place.x, p.place.y - first.place.y};
            const double twice = cross(u, v), sum = first.depth + before.depth + p.depth;
            area += 0.5 * twice;
            push += twice * sum;
            x += 0.25 * twice * (sum * (u.x + v.x) + before.depth * u.x + p.depth * v.x);
            y += 0.25 * twice * (sum * (u.y + v.y) + before.depth * u.y + p.depth * v.y);
        }
        before = p;
    };
    for (std::size_t i = 0; i < patch.size(); ++i) {
        const PatchCorner &here = patch.corners[i], &next = patch.next(i);
        if (here.depth > 0) {
            add({here.place, here.depth});
        }
        if ((here.depth > 0) != (next.depth > 0)) {
            const double t = here.depth / (here.depth - next.depth);
            add({{here.place.x + t * (next.place.x - here.place.x), here.place.y + t * (next.place.y - here.place.y)},
                 0});
        }
    }
    return push > 0 ? ClosedPatch{area, {first.place.x + x / push, first.place.y + y / push}}
                    : ClosedPatch{0, first.place};
}

}  // namespace riprap::contact
