// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/round_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"

namespace riprap::solid::affine {

using contact::PlacedHull;

namespace {

/// Names the only contact point of a ball with a body, and the first of the two of a disc.
constexpr std::uint64_t ball_feature = std::uint64_t{4} << 60U;

/// Point of the surface of a convex body next to a point, and the direction from it.
struct Nearest {
    Vec3 point, outward;
};

Vec3 nearest_on_segment(const Vec3& from, const Vec3& to, const Vec3& x) {
    const Vec3 along = to - from;
    return from + std::clamp(dot(x - from, along) / norm_squared(along), 0.0, 1.0) * along;
}

/// Returns the point of a face that is nearest to a point before it, at the height `above` over its plane.
Vec3 nearest_on_face(const PlacedHull& hull, std::size_t face, const Vec3& x, double above) {
    const Vec3& n = hull.normals[face];
    const auto loop = hull.topology->loop(static_cast<std::int32_t>(face));
    Vec3 best = x - above * n;
    bool is_inside = true;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 &from = hull.vertices[at(loop[i])], &to = hull.vertices[at(loop[(i + 1) % loop.size()])];
        if (dot(cross(n, to - from), x - from) >= 0) {
            continue;
        }
        is_inside = false;
        const Vec3 on_edge = nearest_on_segment(from, to, x);
        if (norm_squared(x - on_edge) < least) {
            least = norm_squared(x - on_edge);
            best = on_edge;
        }
    }
    return is_inside ? x - above * n : best;
}

Nearest nearest_on_hull(const PlacedHull& hull, const Vec3& x) {
    if (hull.is_half_space()) {
        return {x - (dot(hull.normals[0], x) - hull.offset) * hull.normals[0], hull.normals[0]};
    }
    Nearest nearest{};
    double highest = -std::numeric_limits<double>::infinity(), least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < hull.normals.size(); ++f) {
        const Vec3& n = hull.normals[f];
        const double above = dot(n, x - hull.vertices[at(hull.topology->loop(static_cast<std::int32_t>(f))[0])]);
        if (above <= 0) {
            if (highest <= 0 && above > highest) {  // inside so far: the nearest face
                highest = above;
                nearest = {x - above * n, n};
            }
            continue;
        }
        const Vec3 on = nearest_on_face(hull, f, x, above);
        if (highest <= 0 || norm_squared(x - on) < least) {
            least = norm_squared(x - on);
            nearest = {on, (1 / std::sqrt(least)) * (x - on)};
        }
        highest = std::max(highest, above);
    }
    return nearest;
}

}  // namespace

Vec3 farthest_along(const RoundSide& ball, const Vec3& n) {
    const Vec3 back = transpose_times(ball.deformation, n);
    return (ball.ball_radius / norm(back)) * (ball.deformation * back);
}

std::optional<BlockContact> find_at_ball(const contact::PartPair& pair, const RoundSide& a, const RoundSide& b,
                                         double reach) {
    const bool is_a_ball = a.ball_radius > 0;
    const RoundSide &ball = is_a_ball ? a : b, &other = is_a_ball ? b : a;
    Nearest on{};
    if (other.ball_radius > 0) {
        const Vec3 apart = ball.hull.centre - other.hull.centre;
        const double distance = norm(apart);
        on.outward = distance > 0 ? apart / distance : Vec3{0, 0, 1};
        on.point = other.hull.centre + farthest_along(other, on.outward);
    } else {
        on = nearest_on_hull(other.hull, ball.hull.centre);
    }
    const Vec3 tip = ball.hull.centre + farthest_along(ball, -on.outward);
    const double gap = dot(on.outward, tip - on.point);
    if (gap > reach) {
        return std::nullopt;
    }
    const Vec3 opposite = tip - gap * on.outward;
    BlockContact contact{};
    contact.a = pair.a;
    contact.b = pair.b;
    contact.feature = ball_feature;
    contact.normal = is_a_ball ? -on.outward : on.outward;
    contact.on_a = is_a_ball ? tip : opposite;
    contact.on_b = is_a_ball ? opposite : tip;
    contact.gap = gap;
    return contact;
}

BlockContact at_end_of_disc(const BlockContact& middle, double half, bool is_far) {
    BlockContact contact = middle;
    const Vec3 along{0, 0, is_far ? half : -half};
    contact.on_a += along;
    contact.on_b += along;
    contact.feature += is_far ? 1 : 0;
    return contact;
}

}  // namespace riprap::solid::affine
