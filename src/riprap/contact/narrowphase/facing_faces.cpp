// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/facing_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "riprap/contact/narrowphase/lanes.hpp"

namespace riprap::contact {

namespace {

using geometry::ConvexView;

/// cos of 45 degrees, the widest h.
constexpr double widest = 0.70710678118654752440;

/// Corners are as deep as each other up to this share of the size of their part.
constexpr double even = 1e-12;

/// Least of d . x over the vertices.
double least_along(const ConvexView& view, const Vec3& d) {
    const auto along = [&](int i) {
        return Lanes::load(view.vertex_x + i) * d.x + Lanes::load(view.vertex_y + i) * d.y +
               Lanes::load(view.vertex_z + i) * d.z;
    };
    Lanes best = along(0);
    for (int i = geometry::shape_lanes; i < view.vertex_count; i += geometry::shape_lanes) {
        best = min(best, along(i));
    }
    return least(best);
}

/// Adds the depths of a body below all faces of another one.
void add_depths(const PlacedShape& faces, const PlacedShape& body, bool is_of_a, std::vector<FaceDepth>& depths) {
    if (body.is_plane()) {
        return;
    }
    const Vec3 shift = transpose_times(faces.frame.axes, body.frame.origin - faces.frame.origin);
    for (int f = 0; f < faces.shape.face_count; ++f) {
        if (faces.shape.is_internal[f] == 0) {
            const Vec3 n = faces.shape.normal(f);
            const Vec3 local = transpose_times(body.frame.axes, faces.frame.axes * n);
            depths.push_back({faces.shape.offset[f] - dot(n, shift) - least_along(body.shape, local), is_of_a, f});
        }
    }
}

/// Face of a part most nearly along a world direction, -1 where it has none.
int face_towards(const PlacedShape& part, const Vec3& direction) {
    const Vec3 local = transpose_times(part.frame.axes, direction);
    int best = -1;
    double most = -2;
    for (int f = 0; f < part.shape.face_count; ++f) {
        const double along = dot(part.shape.normal(f), local);
        if (part.shape.is_internal[f] == 0 && along > most) {
            most = along;
            best = f;
        }
    }
    return best;
}

/// cos of the angle between a face and the nearest other one.
double bend_of(const ConvexView& shape, int face) {
    double bend = -1;
    for (int f = 0; f < shape.face_count; ++f) {
        if (f != face && shape.is_internal[f] == 0) {
            bend = std::max(bend, dot(shape.normal(face), shape.normal(f)));
        }
    }
    return bend;
}

/// True where an edge of a face lies in a cut through its body. End faces of planar prisms, across z, are no cuts.
bool borders_a_cut(const ConvexView& shape, int face) {
    const auto loop = [&](int f) {
        return std::span(shape.face_vertex + shape.face_start[f], shape.face_vertex + shape.face_start[f + 1]);
    };
    for (int f = 0; f < shape.face_count; ++f) {
        if (shape.is_internal[f] == 0 || std::abs(shape.normal_z[f]) == 1) {
            continue;
        }
        const auto common = std::ranges::count_if(
            loop(face), [&](std::int32_t v) { return std::ranges::find(loop(f), v) != loop(f).end(); });
        if (common > 1) {
            return true;
        }
    }
    return false;
}

double cosine_of_half(double cosine) { return std::sqrt(std::max(0.0, 0.5 * (1 + cosine))); }

void set_share(const PlacedShape& a, const PlacedShape& b, FacingFaces& faces) {
    const double bend = std::max(bend_of(a.shape, faces.of_a), bend_of(b.shape, faces.of_b));
    faces.rise = bend > widest ? std::sqrt(std::max(0.0, 1 - bend * bend)) / bend : 1;
    const double none = std::max(widest, cosine_of_half(bend)), all = cosine_of_half(none);
    const double cosine = -dot(faces.normal_a, faces.normal_b);
    if (cosine <= none || none >= all || borders_a_cut(a.shape, faces.of_a) || borders_a_cut(b.shape, faces.of_b)) {
        return;
    }
    const double s = std::min(1.0, (cosine - none) / (all - none));
    faces.share = s * s * (3 - 2 * s);
    faces.share_by_cosine = s < 1 ? 6 * s * (1 - s) / (all - none) : 0;
}

}  // namespace

FacingFaces find_facing_faces(const PlacedShape& a, const PlacedShape& b) {
    static thread_local std::vector<FaceDepth> depths;
    depths.clear();
    add_depths(a, b, true, depths);
    add_depths(b, a, false, depths);
    FacingFaces faces;
    faces.least = faces.next = {std::numeric_limits<double>::infinity(), true};
    for (const FaceDepth& depth : depths) {
        faces.least = depth.depth < faces.least.depth ? depth : faces.least;
    }
    if (faces.least.face < 0 || !(faces.least.depth > 0)) {
        return faces;
    }
    const bool is_of_a = faces.least.is_of_a;
    const PlacedShape &own = is_of_a ? a : b, &other = is_of_a ? b : a;
    const Vec3 normal = own.frame.axes * own.shape.normal(faces.least.face);
    const int partner = face_towards(other, -normal);
    if (partner < 0) {
        return faces;
    }
    const Vec3 opposed = other.frame.axes * other.shape.normal(partner);
    faces.of_a = is_of_a ? faces.least.face : partner;
    faces.of_b = is_of_a ? partner : faces.least.face;
    faces.normal_a = is_of_a ? normal : opposed;
    faces.normal_b = is_of_a ? opposed : normal;
    faces.origin = a.is_plane() ? b.frame.origin : a.frame.origin;
    set_share(a, b, faces);
    for (const FaceDepth& depth : depths) {
        const bool is_other = depth.face != (depth.is_of_a ? faces.of_a : faces.of_b);
        faces.next = is_other && depth.depth < faces.next.depth ? depth : faces.next;
    }
    return faces;
}

namespace {

Vec3 nearest_between(const Vec3& p, const Vec3& q, const Vec3& to) {
    const Vec3 whole = q - p;
    return p + std::clamp(dot(to - p, whole) / norm_squared(whole), 0.0, 1.0) * whole;
}

/// Point of the hull of corners in one plane that is nearest to `to`.
Vec3 nearest_of(std::vector<Vec3>& corners, const Vec3& normal, const Vec3& to) {
    Vec3 middle{};
    for (const Vec3& corner : corners) {
        middle += corner / static_cast<double>(corners.size());
    }
    const Vec3 x = corners[0] - middle, y = cross(normal, x);
    std::ranges::sort(corners, {}, [&](const Vec3& p) { return std::atan2(dot(p - middle, y), dot(p - middle, x)); });
    Vec3 nearest = to - dot(to - middle, normal) * normal;
    const Vec3 inside = nearest;
    double least = std::numeric_limits<double>::infinity();
    bool is_inside = corners.size() > 2;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 &p = corners[i], &q = corners[i + 1 < corners.size() ? i + 1 : 0];
        is_inside = is_inside && dot(cross(normal, q - p), inside - p) >= 0;
        const Vec3 place = nearest_between(p, q, inside);
        if (norm_squared(place - inside) < least) {
            least = norm_squared(place - inside);
            nearest = place;
        }
    }
    return is_inside ? inside : nearest;
}

}  // namespace

DeepestCorner deepest_corner(const PlacedShape& a, const PlacedShape& b, const FaceDepth& depth, const Vec3& origin,
                             const Vec3& near) {
    const PlacedShape &face = depth.is_of_a ? a : b, &body = depth.is_of_a ? b : a;
    const Vec3 normal = face.frame.axes * face.shape.normal(depth.face);
    const Vec3 local = transpose_times(body.frame.axes, normal);
    const double deepest = least_along(body.shape, local), slack = even * body.shape.circumradius;
    std::vector<Vec3> corners;
    for (int v = 0; v < body.shape.vertex_count; ++v) {
        if (dot(local, body.shape.vertex(v)) <= deepest + slack) {
            corners.push_back((body.frame.origin - origin) + body.frame.axes * body.shape.vertex(v));
        }
    }
    return {normal, corners.size() == 1 ? corners[0] : nearest_of(corners, normal, near)};
}

}  // namespace riprap::contact
