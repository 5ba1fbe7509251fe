// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/contact/narrowphase/common_plane.hpp"
#include "riprap/core/index.hpp"

namespace riprap::contact {

namespace {

struct Segment {
    Vec3 from, along;
};

Segment segment(const PlacedHull& hull, const HullEdge& edge) {
    const Vec3& x = hull.vertices[at(edge.from)];
    return {x, hull.vertices[at(edge.to)] - x};
}

/// Do the arcs of two edges on the sphere of normals cross, those of B mirrored, or one the far side of the other?
/// Only where they cross is the pair a face of the Minkowski difference [Gregorius2013]; where they only touch, a face
/// normal of A or B is the same plane.
bool do_arcs_cross(const PlacedHull& a, const HullEdge& ea, const Vec3& along_a, const PlacedHull& b,
                   const HullEdge& eb, const Vec3& along_b) {
    const Vec3 &na = a.normals[at(ea.left)], &nb = a.normals[at(ea.right)];
    const Vec3 nc = -b.normals[at(eb.left)], nd = -b.normals[at(eb.right)];
    const double c = dot(nc, along_a), d = dot(nd, along_a), p = dot(na, along_b), q = dot(nb, along_b);
    return c * d <= 0 && p * q <= 0;
}

CommonPlane best_face(const PlacedHull& a, const PlacedHull& b) {
    CommonPlane best{{0, 0, 1}, -std::numeric_limits<double>::infinity(), {}, false};
    const auto offer = [&](const Vec3& n, const PlaneFeature& feature) {
        const double gap = plane_gap(a, b, n);
        if (gap > best.gap) {
            best = {n, gap, feature, false};
        }
    };
    for (std::size_t f = 0; f < a.normals.size(); ++f) {
        offer(a.normals[f], {PlaneKind::face_a, static_cast<std::int32_t>(f), -1});
    }
    for (std::size_t f = 0; f < b.normals.size(); ++f) {
        offer(-b.normals[f], {PlaneKind::face_b, -1, static_cast<std::int32_t>(f)});
    }
    return best;
}

/// Improves `best` over all pairs of edges. A pair of crossing edges wins only where it is clearly better, as a face
/// gives the better contact points.
void offer_edges(const PlacedHull& a, const PlacedHull& b, CommonPlane& best) {
    const double margin = 1e-12 * (norm(b.centre - a.centre) + std::abs(best.gap));
    for (std::size_t i = 0; i < a.topology->edges.size(); ++i) {
        const HullEdge& ea = a.topology->edges[i];
        const Segment sa = segment(a, ea);
        for (std::size_t j = 0; j < b.topology->edges.size(); ++j) {
            const HullEdge& eb = b.topology->edges[j];
            const Segment sb = segment(b, eb);
            if (!do_arcs_cross(a, ea, sa.along, b, eb, sb.along)) {
                continue;
            }
            Vec3 n = cross(sa.along, sb.along);
            const double size = norm(n);
            if (size <= 1e-9 * norm(sa.along) * norm(sb.along)) {
                continue;
            }
            n = n / size;
            // Out of A: along the mean of the two faces beside the edge.
            n = dot(n, a.normals[at(ea.left)] + a.normals[at(ea.right)]) < 0 ? -n : n;
            if (dot(n, b.normals[at(eb.left)] + b.normals[at(eb.right)]) > 0) {
                continue;  // the far side
            }
            const double gap = dot(n, sb.from - sa.from);
            if (gap > best.gap + margin && plane_gap(a, b, n) > best.gap + margin) {
                best = {n,
                        plane_gap(a, b, n),
                        {PlaneKind::edges, static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)},
                        false};
            }
        }
    }
}

/// Nearest points of two segments [Ericson2005, 5.1.9].
Vec3 link_of(const Segment& p, const Segment& q) {
    const Vec3 r = p.from - q.from;
    const double a = norm_squared(p.along), e = norm_squared(q.along), f = dot(q.along, r);
    const double c = dot(p.along, r), b = dot(p.along, q.along), denominator = a * e - b * b;
    double s = denominator > 1e-14 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
    double t = (b * s + f) / e;
    if (t < 0 || t > 1) {
        t = std::clamp(t, 0.0, 1.0);
        s = std::clamp((b * t - c) / a, 0.0, 1.0);
    }
    return q.from + t * q.along - p.from - s * p.along;
}

/// The shortest link from a corner to the faces of a body that it is outside of.
Vec3 link_to_faces(const Vec3& x, const PlacedHull& hull) {
    Vec3 best{1e300, 0, 0};
    for (std::size_t f = 0; f < hull.normals.size(); ++f) {
        const auto loop = hull.topology->loop(static_cast<std::int32_t>(f));
        const Vec3& n = hull.normals[f];
        const double height = dot(n, x - hull.vertices[at(loop[0])]);
        bool is_inside = height > 0;
        for (std::size_t k = 0; is_inside && k < loop.size(); ++k) {
            const Vec3& p = hull.vertices[at(loop[k])];
            const Vec3& q = hull.vertices[at(loop[(k + 1) % loop.size()])];
            is_inside = dot(cross(n, q - p), x - p) >= 0;
        }
        if (is_inside && height * height < norm_squared(best)) {
            best = -height * n;
        }
    }
    return best;
}

/// The plane across the nearest points of two bodies apart.
CommonPlane plane_of_link(const PlacedHull& a, const PlacedHull& b, const CommonPlane& otherwise) {
    Vec3 best{1e300, 0, 0};
    const auto offer = [&best](const Vec3& link) { best = norm_squared(link) < norm_squared(best) ? link : best; };
    for (const Vec3& x : a.vertices) {
        offer(link_to_faces(x, b));
    }
    for (const Vec3& x : b.vertices) {
        offer(-link_to_faces(x, a));
    }
    for (const HullEdge& ea : a.topology->edges) {
        for (const HullEdge& eb : b.topology->edges) {
            offer(link_of(segment(a, ea), segment(b, eb)));
        }
    }
    const double length = norm(best);
    if (!(length > 0)) {
        return otherwise;
    }
    // The direction of a very short link has lost digits; a face or a pair of edges has not.
    const Vec3 n = best / length;
    const double gap = plane_gap(a, b, n);
    return gap > otherwise.gap * (1 + 1e-12) ? CommonPlane{n, gap, {PlaneKind::link, -1, -1}, false} : otherwise;
}

}  // namespace

CommonPlane common_plane_exact(const PlacedHull& a, const PlacedHull& b) {
    if (a.is_half_space() || b.is_half_space()) {
        return common_plane_fast(a, b, {});
    }
    CommonPlane best = best_face(a, b);
    offer_edges(a, b, best);
    return best.gap > 0 ? plane_of_link(a, b, best) : best;
}

}  // namespace riprap::contact
