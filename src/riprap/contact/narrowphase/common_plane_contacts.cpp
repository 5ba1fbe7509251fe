// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/common_plane_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "riprap/contact/narrowphase/hull_size.hpp"
#include "riprap/contact/narrowphase/touching_set.hpp"
#include "riprap/core/index.hpp"

namespace riprap::contact {

namespace {

std::uint64_t key(int kind, std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    const auto bits = [](std::int32_t i) { return static_cast<std::uint64_t>(i + 1) & 0x7FFFU; };
    return static_cast<std::uint64_t>(kind) << 60 | bits(a) << 45 | bits(b) << 30 | bits(c) << 15 | bits(d);
}

/// The surface of a body under (or over) the common plane: the plane of the face that turns most towards it.
struct Facing {
    Vec3 normal;
    double offset;

    Facing(const PlacedHull& hull, const Vec3& outward) {
        const std::size_t best = facing_face(hull, outward);
        normal = hull.normals[best];
        offset = hull.is_half_space()
                     ? hull.offset
                     : dot(normal, hull.vertices[at(hull.topology->loop(static_cast<std::int32_t>(best))[0])]);
    }
    /// The point of the surface that x is moved to along n.
    Vec3 along(const Vec3& n, const Vec3& x) const { return x + ((offset - dot(normal, x)) / dot(normal, n)) * n; }
};

/// Both bodies as they face each other.
struct Sides {
    const PlacedHull &a, &b;
    Vec3 n;
    PlaneAxes axes;
    double tolerance;
    TouchingSet set_a, set_b;
    const Vec3& corner_a(int i) const { return a.vertices[at(set_a.vertex[at(i)])]; }
    const Vec3& corner_b(int i) const { return b.vertices[at(set_b.vertex[at(i)])]; }
    std::int32_t id_a(int i) const { return set_a.vertex[at(i)]; }
    std::int32_t id_b(int i) const { return set_b.vertex[at(i)]; }
};

/// Returns the distance of the farthest corner from the centre [m].
double radius_of(const PlacedHull& hull) {
    double square = 0;
    for (const Vec3& x : hull.vertices) {
        square = std::max(square, norm_squared(x - hull.centre));
    }
    return std::sqrt(square);
}

/// A tolerance stands for an angle: a face that falls by it over half of the smaller body falls by more over its own
/// length, and its far corners touch as well. Else a block that tilts by 1e-4 on a long floor would stand on the end of
/// the floor alone, and lose a corner that is still in.
Touch touch_of(double own_radius, double other_radius, double tolerance) {
    return {tolerance, std::max(1.0, 2 * own_radius / other_radius - 1) * tolerance};
}

Sides sides_of(const PlacedHull& a, const PlacedHull& b, const Vec3& n, double tolerance) {
    const PlaneAxes axes = axes_across(n, a.is_half_space() ? b.centre : a.centre);
    Sides sides{a, b, n, axes, tolerance, {}, {}};
    if (a.is_half_space() || b.is_half_space()) {
        const bool is_a = a.is_half_space();
        (is_a ? sides.set_b : sides.set_a) = touching_set(is_a ? b : a, is_a ? -n : n, {tolerance, 0}, axes);
        return sides;
    }
    const double of_a = radius_of(a), of_b = radius_of(b);
    sides.set_a = touching_set(a, n, touch_of(of_a, of_b, tolerance), axes);
    sides.set_b = touching_set(b, -n, touch_of(of_b, of_a, tolerance), axes);
    return sides;
}

/// Returns the distance outside of an edge within which a point counts as on it [m].
double slack_of(const PlacedHull& a, const PlacedHull& b, double tolerance) {
    return 1e-9 * (norm(b.centre - a.centre) + tolerance) + 1e-6 * tolerance;
}

void add(PlaneContacts& found, const Vec3& on_a, const Vec3& on_b, std::uint64_t feature) {
    if (found.count < most_plane_contacts) {
        found.contacts[at(found.count++)] = {on_a, on_b, dot(found.normal, on_b - on_a), 0, feature};
    }
}

/// The point over p on the edge from..to, as the plane sees it.
Vec3 on_edge(const Vec3& from, const Vec3& to, const PlanePoint& p_from, const PlanePoint& p_to, const PlanePoint& p) {
    const PlanePoint along = p_to - p_from;
    const double t = dot(p - p_from, along) / dot(along, along);
    return from + t * (to - from);
}

ContactType type_of(int count_a, int count_b) {
    const int a = std::min(count_a, 3) - 1, b = std::min(count_b, 3) - 1;
    return static_cast<ContactType>(1 + 3 * a + b);
}

/// Shares a polygon's area among its corners, one contact each: a corner has the quadrangle between the centre and the
/// middles of its two sides.
template <class Point>
void share_area(int count, const Point& point, PlaneContacts& found) {
    if (count < 3) {
        return;
    }
    PlanePoint centre{0, 0};
    for (int i = 0; i < count; ++i) {
        centre = centre + (1.0 / count) * point(i);
    }
    for (int i = 0; i < found.count; ++i) {
        const PlanePoint here = point(i) - centre;
        const PlanePoint next = point((i + 1) % count) - centre, last = point((i + count - 1) % count) - centre;
        found.contacts[at(i)].area = 0.25 * std::abs(cross(here, next) + cross(last, here));
        found.area += found.contacts[at(i)].area;
    }
}

/// Corners of a body that touch inside of the outline of its set, or on a side of it.
std::vector<std::int32_t> inner_corners(const PlacedHull& body, const Vec3& outward, double tolerance,
                                        const TouchingSet& set) {
    const double farthest = dot(outward, body.vertices[at(support_vertex(body, outward))]);
    const auto outline = std::span(set.vertex).first(at(set.count));
    std::vector<std::int32_t> inner;
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(body.vertices.size()); ++v) {
        if (dot(outward, body.vertices[at(v)]) >= farthest - tolerance &&
            std::ranges::find(outline, v) == outline.end()) {
            inner.push_back(v);
        }
    }
    return inner;
}

/// Adds the contacts inside of the outline of the touching corners of one body, where it stands on a flat face of the
/// other: corners there, and where edges between them cross the rim of that face. The lowest corner of a round body
/// or of a blunt tip is one of them. The outline alone lies higher, and its corners would take over all at once when
/// they have come in.
void add_inner(const Sides& s, bool is_of_a, double slack, PlaneContacts& found) {
    const TouchingSet &own = is_of_a ? s.set_a : s.set_b, &other = is_of_a ? s.set_b : s.set_a;
    const PlacedHull &body = is_of_a ? s.a : s.b, &ground = is_of_a ? s.b : s.a;
    const Vec3 outward = is_of_a ? s.n : -s.n;
    if (own.touching == own.count || other.count < 3) {
        return;
    }
    const auto face = ground.topology->loop(static_cast<std::int32_t>(facing_face(ground, -outward)));
    if (other.touching > static_cast<int>(face.size())) {
        return;
    }
    const Facing facing(ground, -outward);
    const auto add_at = [&](const Vec3& x, std::uint64_t feature) {
        const Vec3 foot = facing.along(s.n, x);
        add(found, is_of_a ? x : foot, is_of_a ? foot : x, feature);
    };
    const std::vector<std::int32_t> inner = inner_corners(body, outward, s.tolerance, own);
    for (const std::int32_t v : inner) {
        TouchingSet corner{.count = 1, .touching = 1, .vertex = {v}, .point = {}};
        corner.point[0] = s.axes.project(body.vertices[at(v)]);
        if (has_corner_inside(corner, other, slack)) {
            add_at(body.vertices[at(v)], is_of_a ? key(1, v, -1, -1, -1) : key(2, -1, -1, v, -1));
        }
    }
    const auto is_inner = [&inner](std::int32_t v) { return std::ranges::find(inner, v) != inner.end(); };
    for (const HullEdge& edge : body.topology->edges) {
        if (!is_inner(edge.from) || !is_inner(edge.to)) {
            continue;
        }
        const Vec3 &from = body.vertices[at(edge.from)], &to = body.vertices[at(edge.to)];
        TouchingSet ridge{.count = 2, .touching = 2, .vertex = {edge.from, edge.to}, .point = {}};
        ridge.point[0] = s.axes.project(from);
        ridge.point[1] = s.axes.project(to);
        const CommonPolygon common = intersect(ridge, other, slack);
        for (int i = 0; i < common.count; ++i) {
            const CommonCorner& c = common.corner[at(i)];
            if (c.b_from < 0 || c.a_from < 0) {
                continue;
            }
            const std::int32_t rim_from = other.vertex[at(c.b_from)], rim_to = other.vertex[at(c.b_to)];
            add_at(
                on_edge(from, to, ridge.point[0], ridge.point[1], c.point),
                is_of_a ? key(3, edge.from, edge.to, rim_from, rim_to) : key(3, rim_from, rim_to, edge.from, edge.to));
        }
    }
}

/// Corners of the intersection where at least one touching set is a polygon.
void add_polygon(const Sides& s, double slack, PlaneContacts& found) {
    const CommonPolygon polygon = intersect(s.set_a, s.set_b, slack);
    const Facing facing_a(s.a, s.n), facing_b(s.b, -s.n);
    for (int i = 0; i < polygon.count; ++i) {
        const CommonCorner& c = polygon.corner[at(i)];
        if (c.b_from < 0) {
            const Vec3& x = s.corner_a(c.a_from);
            add(found, x, facing_b.along(s.n, x), key(1, s.id_a(c.a_from), -1, -1, -1));
        } else if (c.a_from < 0) {
            const Vec3& x = s.corner_b(c.b_from);
            add(found, facing_a.along(s.n, x), x, key(2, -1, -1, s.id_b(c.b_from), -1));
        } else {
            const Vec3 on_a = on_edge(s.corner_a(c.a_from), s.corner_a(c.a_to), s.set_a.point[at(c.a_from)],
                                      s.set_a.point[at(c.a_to)], c.point);
            const Vec3 on_b = on_edge(s.corner_b(c.b_from), s.corner_b(c.b_to), s.set_b.point[at(c.b_from)],
                                      s.set_b.point[at(c.b_to)], c.point);
            add(found, on_a, on_b, key(3, s.id_a(c.a_from), s.id_a(c.a_to), s.id_b(c.b_from), s.id_b(c.b_to)));
        }
    }
    share_area(
        polygon.count, [&](int i) { return polygon.corner[at(i)].point; }, found);
    add_inner(s, true, slack, found);
    add_inner(s, false, slack, found);
}

/// A half-space is a face without an end: every touching corner of the other body is a contact. Those inside of the
/// outline of the touching ones may be the lowest, as of a roller, and have no share of its area.
void add_half_space(const Sides& s, double tolerance, PlaneContacts& found) {
    const bool is_a_plane = s.a.is_half_space();
    const TouchingSet& set = is_a_plane ? s.set_b : s.set_a;
    const PlacedHull& body = is_a_plane ? s.b : s.a;
    const Facing facing(is_a_plane ? s.a : s.b, is_a_plane ? s.n : -s.n);
    const auto add_corner = [&](std::int32_t v) {
        const Vec3& x = body.vertices[at(v)];
        const Vec3 foot = facing.along(s.n, x);
        if (is_a_plane) {
            add(found, foot, x, key(2, -1, -1, v, -1));
        } else {
            add(found, x, foot, key(1, v, -1, -1, -1));
        }
    };
    for (int i = 0; i < set.count; ++i) {
        add_corner(set.vertex[at(i)]);
    }
    share_area(
        set.count, [&](int i) { return set.point[at(i)]; }, found);
    const Vec3 outward = is_a_plane ? -s.n : s.n;
    const double farthest = dot(outward, body.vertices[at(support_vertex(body, outward))]);
    const auto outline = std::span(set.vertex).first(at(set.count));
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(body.vertices.size()); ++v) {
        const bool touches = dot(outward, body.vertices[at(v)]) >= farthest - tolerance;
        if (touches && std::find(outline.begin(), outline.end(), v) == outline.end()) {
            add_corner(v);
        }
    }
    found.type = is_a_plane ? type_of(3, set.count) : type_of(set.count, 3);
}

/// A corner of A against a segment of B: its foot, if that falls on the segment or within `slack` of an end.
void add_corner_on_edge_of_b(const Sides& s, int i, double slack, PlaneContacts& found) {
    const PlanePoint p = s.set_b.point[0], along = s.set_b.point[1] - p;
    const double length2 = dot(along, along), t = dot(s.set_a.point[at(i)] - p, along) / length2;
    const double margin = slack / std::sqrt(length2);
    const PlanePoint off = s.set_a.point[at(i)] - p - t * along;
    if (t >= -margin && t <= 1 + margin && (s.set_a.count > 1 || dot(off, off) <= slack * slack)) {
        add(found, s.corner_a(i), s.corner_b(0) + t * (s.corner_b(1) - s.corner_b(0)), key(1, s.id_a(i), -1, -1, -1));
    }
}

void add_corner_on_edge_of_a(const Sides& s, int j, double slack, PlaneContacts& found) {
    const PlanePoint p = s.set_a.point[0], along = s.set_a.point[1] - p;
    const double length2 = dot(along, along), t = dot(s.set_b.point[at(j)] - p, along) / length2;
    const double margin = slack / std::sqrt(length2);
    const PlanePoint off = s.set_b.point[at(j)] - p - t * along;
    if (t >= -margin && t <= 1 + margin && (s.set_b.count > 1 || dot(off, off) <= slack * slack)) {
        add(found, s.corner_a(0) + t * (s.corner_a(1) - s.corner_a(0)), s.corner_b(j), key(2, -1, -1, s.id_b(j), -1));
    }
}

/// Two segments: their crossing, or the ends of the common part where they are parallel (within 1 in 1000).
void add_edges(const Sides& s, double slack, PlaneContacts& found) {
    const PlanePoint p = s.set_a.point[0], u = s.set_a.point[1] - p;
    const PlanePoint q = s.set_b.point[0], v = s.set_b.point[1] - q;
    const double sine = cross(u, v), lengths = std::sqrt(dot(u, u) * dot(v, v));
    if (std::abs(sine) > 1e-3 * lengths) {
        const double t = cross(q - p, v) / sine, r = cross(q - p, u) / sine;
        const double margin_a = slack / std::sqrt(dot(u, u)), margin_b = slack / std::sqrt(dot(v, v));
        if (t >= -margin_a && t <= 1 + margin_a && r >= -margin_b && r <= 1 + margin_b) {
            add(found, s.corner_a(0) + t * (s.corner_a(1) - s.corner_a(0)),
                s.corner_b(0) + r * (s.corner_b(1) - s.corner_b(0)),
                key(3, s.id_a(0), s.id_a(1), s.id_b(0), s.id_b(1)));
        }
        return;
    }
    const double apart = std::abs(cross(q - p, u)) / std::sqrt(dot(u, u));
    const double length = std::sqrt(std::max(dot(u, u), dot(v, v)));
    // Edges of a slender body are longer than its faces are wide: those of either side would count as one.
    if (apart > slack + 1e-3 * std::min(length, 2 * std::min(size_of(s.a), size_of(s.b)))) {
        return;
    }
    for (int i = 0; i < 2; ++i) {
        add_corner_on_edge_of_b(s, i, 0, found);
    }
    for (int j = 0; j < 2 && found.count < 2; ++j) {
        add_corner_on_edge_of_a(s, j, 0, found);
    }
}

}  // namespace

std::string_view to_string(ContactType type) {
    constexpr std::array<std::string_view, 10> names{"none",        "vertex-vertex", "vertex-edge", "vertex-face",
                                                     "edge-vertex", "edge-edge",     "edge-face",   "face-vertex",
                                                     "face-edge",   "face-face"};
    return names[static_cast<std::size_t>(type)];
}

double contact_tolerance(const PlacedHull& a, const PlacedHull& b, const CommonPlane& plane) {
    const double size = std::min(size_of(a), size_of(b));
    return std::min(2 * std::abs(plane.gap) + 1e-4 * size, 0.1 * size);
}

namespace {

/// Fills the contacts of the features within `tolerance`.
void find_within(const PlacedHull& a, const PlacedHull& b, const CommonPlane& plane, double tolerance,
                 PlaneContacts& found) {
    found.type = ContactType::none;
    found.normal = plane.normal;
    found.area = 0;
    found.count = 0;
    const Sides sides = sides_of(a, b, plane.normal, tolerance);
    if (a.is_half_space() || b.is_half_space()) {
        add_half_space(sides, tolerance, found);
        return;
    }
    const double slack = slack_of(a, b, tolerance);
    const int count_a = sides.set_a.count, count_b = sides.set_b.count;
    if (count_a > 2 || count_b > 2) {
        add_polygon(sides, slack, found);
    } else if (count_a == 2 && count_b == 2) {
        add_edges(sides, slack, found);
    } else if (count_b == 2) {
        add_corner_on_edge_of_b(sides, 0, std::max(slack, tolerance), found);
    } else if (count_a == 2) {
        add_corner_on_edge_of_a(sides, 0, std::max(slack, tolerance), found);
    } else {
        const PlanePoint off = sides.set_b.point[0] - sides.set_a.point[0];
        if (dot(off, off) <= tolerance * tolerance) {
            add(found, sides.corner_a(0), sides.corner_b(0), key(1, sides.id_a(0), -1, -1, -1));
        }
    }
    if (found.count > 0) {
        found.type = type_of(count_a, count_b);
    }
}

/// Returns the least gap of the contacts; 0 where none overlaps [m].
double deepest_gap(const PlaneContacts& found) {
    double least = 0;
    for (int k = 0; k < found.count; ++k) {
        least = std::min(least, found.contacts[at(k)].gap);
    }
    return least;
}

}  // namespace

void find_plane_contacts(const PlacedHull& a, const PlacedHull& b, const CommonPlane& plane, double tolerance,
                         PlaneContacts& found) {
    find_within(a, b, plane, tolerance, found);
    // Corners beside a ridge or a tip that touch as well make an outline around it, and what lies deepest has no part
    // in that. Features within a quarter of the depth are at least half as deep where they meet.
    const double shallow = 0.25 * -plane.gap;
    if (shallow > 0 && shallow < tolerance && deepest_gap(found) > 0.5 * plane.gap) {
        PlaneContacts deep;
        find_within(a, b, plane, shallow, deep);
        if (deep.count > 0) {
            found = deep;
        }
    }
}

bool do_features_meet(const PlacedHull& a, const PlacedHull& b, const CommonPlane& plane, double tolerance) {
    if (!a.is_half_space() && !b.is_half_space()) {
        const Sides sides = sides_of(a, b, plane.normal, tolerance);
        const bool is_a_subject = sides.set_b.count > 2;
        const TouchingSet &subject = is_a_subject ? sides.set_a : sides.set_b,
                          &by = is_a_subject ? sides.set_b : sides.set_a;
        if (by.count > 2 && has_corner_inside(subject, by, slack_of(a, b, tolerance))) {
            return true;  // most faces that meet do so there
        }
    }
    PlaneContacts found;
    find_plane_contacts(a, b, plane, tolerance, found);
    return found.count > 0;
}

}  // namespace riprap::contact
