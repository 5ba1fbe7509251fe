// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/common_plane.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/contact/narrowphase/best_plane.hpp"
#include "riprap/contact/narrowphase/common_plane_contacts.hpp"
#include "riprap/contact/narrowphase/hull_size.hpp"
#include "riprap/core/index.hpp"

namespace riprap::contact {

namespace {

constexpr int most_rounds = 20;

/// Planes parallel to the faces around the nearest corners.
void offer_faces(const PlacedHull& a, const PlacedHull& b, std::int32_t va, std::int32_t vb, BestPlane& best) {
    for (const std::int32_t f : a.topology->faces_around(va)) {
        best.offer(a.normals[at(f)], {PlaneKind::face_a, f, -1});
    }
    for (const std::int32_t f : b.topology->faces_around(vb)) {
        best.offer(-b.normals[at(f)], {PlaneKind::face_b, -1, f});
    }
}

/// Planes parallel to one edge of each of the two nearest corners.
void offer_edge_pairs(const PlacedHull& a, const PlacedHull& b, std::int32_t va, std::int32_t vb, BestPlane& best) {
    for (const std::int32_t wa : a.topology->neighbours(va)) {
        const Vec3 ea = a.vertices[at(wa)] - a.vertices[at(va)];
        for (const std::int32_t wb : b.topology->neighbours(vb)) {
            const Vec3 eb = b.vertices[at(wb)] - b.vertices[at(vb)];
            const Vec3 n = cross(ea, eb);
            if (norm_squared(n) > least_sine * least_sine * norm_squared(ea) * norm_squared(eb)) {
                best.offer_axis(n, {PlaneKind::edges, wa, wb});
            }
        }
    }
}

/// Across the link of the nearest corners, whole or without its part along an edge. Only for bodies apart: where they
/// overlap the link points the other way.
void offer_links(const PlacedHull& a, const PlacedHull& b, std::int32_t va, std::int32_t vb, BestPlane& best) {
    const Vec3 link = b.vertices[at(vb)] - a.vertices[at(va)];
    const double length = norm(link);
    if (!(length > 0)) {
        return;
    }
    best.offer(link / length, {PlaneKind::link, -1, -1});
    const auto offer_across = [&](const PlacedHull& hull, std::int32_t v) {
        for (const std::int32_t w : hull.topology->neighbours(v)) {
            const Vec3 e = normalized(hull.vertices[at(w)] - hull.vertices[at(v)]);
            const Vec3 n = link - dot(link, e) * e;
            if (norm(n) > least_sine * length) {
                best.offer(normalized(n), {PlaneKind::link, -1, -1});
            }
        }
    };
    offer_across(a, va);
    offer_across(b, vb);
}

double smaller_size(const PlacedHull& a, const PlacedHull& b) { return std::min(size_of(a), size_of(b)); }

/// A half-space allows one plane: its own.
CommonPlane plane_of_half_space(const PlacedHull& a, const PlacedHull& b) {
    const Vec3 n = b.is_half_space() ? -b.normals[0] : a.normals[0];
    return {n, plane_gap(a, b, n), {b.is_half_space() ? PlaneKind::face_b : PlaneKind::face_a, 0, 0}, false};
}

/// The face of a body that turns most towards `outward`.
std::int32_t facing_face(const PlacedHull& hull, const Vec3& outward) {
    std::size_t best = 0;
    for (std::size_t f = 1; f < hull.normals.size(); ++f) {
        best = dot(hull.normals[f], outward) > dot(hull.normals[best], outward) ? f : best;
    }
    return static_cast<std::int32_t>(best);
}

/// Puts a plane parallel to a face halfway to the face opposite, where that one is as good and nearly parallel.
void share_plane(const PlacedHull& a, const PlacedHull& b, double tolerance, CommonPlane& plane) {
    if (plane.feature.kind != PlaneKind::face_a && plane.feature.kind != PlaneKind::face_b) {
        return;
    }
    const bool is_of_a = plane.feature.kind == PlaneKind::face_a;
    const PlaneFeature shared{PlaneKind::faces, is_of_a ? plane.feature.a : facing_face(a, plane.normal),
                              is_of_a ? facing_face(b, -plane.normal) : plane.feature.b};
    const Vec3 other = is_of_a ? -b.normals[at(shared.b)] : a.normals[at(shared.a)];
    if (dot(other, plane.normal) > 0.9 && plane_gap(a, b, other) > plane.gap - tolerance) {
        const Vec3 n = feature_normal(a, b, shared);
        plane = {n, plane_gap(a, b, n), shared, plane.is_fallback};
    }
}

}  // namespace

std::uint64_t pack(const PlaneFeature& feature) {
    return static_cast<std::uint64_t>(feature.kind) << 56 |
           (static_cast<std::uint64_t>(feature.a + 1) & 0xFFFFFFFU) << 28 |
           (static_cast<std::uint64_t>(feature.b + 1) & 0xFFFFFFFU);
}

PlaneFeature unpack_feature(std::uint64_t packed) {
    return {static_cast<PlaneKind>(packed >> 56), static_cast<std::int32_t>(packed >> 28 & 0xFFFFFFFU) - 1,
            static_cast<std::int32_t>(packed & 0xFFFFFFFU) - 1};
}

double plane_gap(const PlacedHull& a, const PlacedHull& b, const Vec3& normal) {
    const double most_a = a.is_half_space() ? a.offset : dot(normal, a.vertices[at(support_vertex(a, normal))]);
    const double least_b = b.is_half_space() ? -b.offset : dot(normal, b.vertices[at(support_vertex(b, -normal))]);
    return least_b - most_a;
}

Vec3 feature_normal(const PlacedHull& a, const PlacedHull& b, const PlaneFeature& feature) {
    const auto direction = [](const PlacedHull& hull, std::int32_t edge) {
        const HullEdge& e = hull.topology->edges[at(edge)];
        return hull.vertices[at(e.to)] - hull.vertices[at(e.from)];
    };
    switch (feature.kind) {
        case PlaneKind::face_a:
            return a.normals[at(feature.a)];
        case PlaneKind::face_b:
            return -b.normals[at(feature.b)];
        case PlaneKind::faces:
            return normalized(a.normals[at(feature.a)] - b.normals[at(feature.b)]);
        case PlaneKind::edges: {
            const Vec3 ea = direction(a, feature.a), eb = direction(b, feature.b);
            const Vec3 n = cross(ea, eb);
            if (norm_squared(n) <= least_sine * least_sine * norm_squared(ea) * norm_squared(eb)) {
                return {};
            }
            return dot(n, b.centre - a.centre) < 0 ? normalized(-n) : normalized(n);
        }
        default:
            return {};
    }
}

CommonPlane common_plane_fast(const PlacedHull& a, const PlacedHull& b, const Vec3& start) {
    if (a.is_half_space() || b.is_half_space()) {
        return plane_of_half_space(a, b);
    }
    Vec3 n = norm_squared(start) > 0 ? normalized(start) : b.centre - a.centre;
    n = norm_squared(n) > 0 ? normalized(n) : Vec3{0, 0, 1};
    const double margin = 1e-12 * (norm(b.centre - a.centre) + std::abs(plane_gap(a, b, n)));
    CommonPlane plane{n, -1e300, {}, false};
    std::int32_t last_a = -1, last_b = -1;
    bool was_apart = false;
    for (int round = 0; round < most_rounds; ++round) {
        const std::int32_t va = support_vertex(a, plane.normal), vb = support_vertex(b, -plane.normal);
        const bool is_apart = dot(b.vertices[at(vb)] - a.vertices[at(va)], plane.normal) > 0;
        if (va == last_a && vb == last_b && is_apart == was_apart) {
            break;  // the same candidates again
        }
        last_a = va;
        last_b = vb;
        was_apart = is_apart;
        BestPlane best(a, b, va, vb, margin);
        offer_faces(a, b, va, vb, best);
        offer_edge_pairs(a, b, va, vb, best);
        if (is_apart) {
            offer_links(a, b, va, vb, best);
        }
        const CommonPlane& found = best.plane();
        if (found.gap <= plane.gap + margin) {
            break;
        }
        plane = found;
    }
    return plane;
}

CommonPlane common_plane_near(const PlacedHull& a, const PlacedHull& b, const Vec3& before, double reach) {
    if (a.is_half_space() || b.is_half_space()) {
        return plane_of_half_space(a, b);
    }
    const bool has_memory = norm_squared(before) > 0;
    CommonPlane plane = common_plane_fast(a, b, before);
    if (plane.gap > reach) {
        return plane;
    }
    const bool is_certain = (has_memory || plane.gap > 0) && do_features_meet(a, b, plane, 1e-9 * smaller_size(a, b));
    if (!is_certain) {
        plane = common_plane_exact(a, b);
        plane.is_fallback = true;
    }
    return plane;
}

CommonPlane common_plane(const PlacedHull& a, const PlacedHull& b, const PlaneFeature& before, double reach) {
    const bool is_plane = a.is_half_space() || b.is_half_space();
    const Vec3 old_normal = is_plane ? Vec3{} : feature_normal(a, b, before);
    CommonPlane plane = common_plane_near(a, b, old_normal, reach);
    if (is_plane || plane.gap > reach) {
        return plane;
    }
    const double tolerance = 1e-6 * smaller_size(a, b);
    if (norm_squared(old_normal) > 0 && before.kind != PlaneKind::faces) {
        const double old_gap = plane_gap(a, b, old_normal);
        if (old_gap > plane.gap - tolerance) {
            plane = {old_normal, old_gap, before, plane.is_fallback};
        }
    }
    share_plane(a, b, tolerance, plane);
    if ((before.kind == PlaneKind::link || before.kind == PlaneKind::none) && plane.gap < tolerance) {
        share_plane_of_tips(a, b, tolerance, plane);
    }
    return plane;
}

}  // namespace riprap::contact
