// SPDX-License-Identifier: Apache-2.0
// Sharp points of the ground on faces of a block, and edges of both that cross.
#include <cmath>

#include "riprap/solid/affine/ground_meeting.hpp"

namespace riprap::solid::affine {

namespace {

/// Ends of edges and of faces count as longer by this share, so that nothing falls between two of them [-].
constexpr double end_slack = 1e-9;
/// Edges more nearly parallel than this (sine) do not cross [-].
constexpr double parallel = 1e-3;

/// Tells whether the pair met at this feature in the last step.
bool is_remembered(const BlockContactHistory& history, std::size_t begin, std::size_t end, std::uint64_t feature) {
    for (std::size_t row = begin; row < end; ++row) {
        if (history.feature[row] == feature) {
            return true;
        }
    }
    return false;
}

/// Returns the least cosine of the angle to the middle of an arc of normals that still counts as within it.
double least_cosine(double half_cosine) {
    static const double c = std::cos(geometry::steep_turn), s = std::sin(geometry::steep_turn);
    return half_cosine * c - std::sqrt(std::max(0.0, 1 - half_cosine * half_cosine)) * s;
}

}  // namespace

/// Tells whether the surface around a point falls away from a plane through it, within steep_turn.
bool GroundMeeting::falls_away(std::int32_t point, const Vec3& down) const {
    static const double lean = -std::sin(geometry::steep_turn);
    const Vec3& x = mesh_.points[at(point)];
    for (const std::int32_t e : features_.fan(point)) {
        const geometry::SurfaceEdge& edge = features_.edge(e);
        const Vec3 out = mesh_.points[at(edge.from == point ? edge.to : edge.from)] - x;
        if (dot(down, out) < lean * norm(out)) {
            return false;
        }
    }
    return true;
}

/// Tells whether the foot of x lies on a face.
bool GroundMeeting::is_over(std::size_t face, const Vec3& x) const {
    const Vec3& n = block_.normals[face];
    const auto loop = block_.topology.loop(static_cast<std::int32_t>(face));
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3 &p = block_.vertices[at(loop[k])], &q = block_.vertices[at(loop[(k + 1) % loop.size()])];
        const Vec3 across = cross(q - p, n);  // out of the face, as long as the edge
        if (dot(across, x - p) > end_slack * norm_squared(q - p)) {
            return false;
        }
    }
    return true;
}

void GroundMeeting::add_points(const BlockContactHistory& history, std::size_t begin, std::size_t end) {
    for (const std::int32_t p : near_.points) {
        const Vec3& x = mesh_.points[at(p)];
        if (!Box{x, x}.meets(block_.box, reach_)) {
            continue;
        }
        std::size_t best = block_.normals.size();
        double gap = 0;
        for (std::size_t f = 0; f < block_.normals.size(); ++f) {
            const Vec3& n = block_.normals[f];
            const Vec3& on_face = block_.vertices[at(block_.topology.loop(static_cast<std::int32_t>(f))[0])];
            const double here = dot(n, x - on_face);
            const bool may = here <= reach_ && here > dot(n, block_.centre - on_face) &&
                             dot(n, features_.facing(p)) < 0 && is_over(f, x) && falls_away(p, n);
            if (!may) {
                continue;
            }
            const bool was_met = is_remembered(history, begin, end, ground_feature(GroundKind::point, f, p));
            if (was_met || best == block_.normals.size() || here > gap) {
                best = f;
                gap = here;
            }
            if (was_met) {
                break;
            }
        }
        if (best < block_.normals.size()) {
            const Vec3& n = block_.normals[best];
            add(GroundKind::point, best, p, -n, x, x - gap * n);
        }
    }
}

void GroundMeeting::add_edges() {
    for (const std::int32_t e : near_.edges) {
        const geometry::SurfaceEdge& edge = features_.edge(e);
        Box box{mesh_.points[at(edge.from)], mesh_.points[at(edge.from)]};
        box.add(mesh_.points[at(edge.to)]);
        if (!box.meets(block_.box, reach_)) {
            continue;
        }
        for (std::size_t i = 0; i < block_.topology.edges.size(); ++i) {
            add_crossing(e, edge, i);
        }
    }
}

void GroundMeeting::add_crossing(std::int32_t e, const geometry::SurfaceEdge& edge, std::size_t i) {
    const contact::HullEdge& other = block_.topology.edges[i];
    const Vec3 &p = mesh_.points[at(edge.from)], &q = block_.vertices[at(other.from)];
    const Vec3 along = mesh_.points[at(edge.to)] - p, across = block_.vertices[at(other.to)] - q;
    const Vec3 product = cross(along, across);
    const double square = norm_squared(product);
    if (square <= parallel * parallel * norm_squared(along) * norm_squared(across)) {
        return;
    }
    Vec3 n = product / std::sqrt(square);
    n = dot(n, edge.mean) < 0 ? -n : n;
    const double gap = dot(n, q - p);
    if (gap > reach_ || dot(n, block_.centre - p) <= 0 || dot(n, edge.mean) < least_cosine(edge.half_cosine)) {
        return;
    }
    const Vec3 &left = block_.normals[at(other.left)], sum = left + block_.normals[at(other.right)];
    const Vec3 mean = normalized(sum);
    if (-dot(n, mean) < least_cosine(dot(mean, left))) {
        return;
    }
    const double t = dot(cross(q - p, across), product) / square, r = dot(cross(q - p, along), product) / square;
    const auto is_on = [](double share) { return share >= -end_slack && share <= 1 + end_slack; };
    if (is_on(t) && is_on(r)) {
        add(GroundKind::edges, i, e, n, p + t * along, q + r * across);
    }
}

}  // namespace riprap::solid::affine
