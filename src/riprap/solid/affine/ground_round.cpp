// SPDX-License-Identifier: Apache-2.0
// A ball, or a disc of a planar scene, on triangles of the ground: as what it is, not as the polyhedron that stands
// for it.
#include <cmath>
#include <limits>

#include "riprap/geometry/surface/triangle.hpp"
#include "riprap/solid/affine/ground_meeting.hpp"

namespace riprap::solid::affine {

namespace {

/// Share of the radius within which two distances are one.
constexpr double same = 1e-9;

}  // namespace

GroundMeeting::NearestOn GroundMeeting::nearest_on(std::int32_t triangle) const {
    const auto on = geometry::nearest_on_triangle(mesh_.corner(triangle, 0), mesh_.corner(triangle, 1),
                                                  mesh_.corner(triangle, 2), block_.centre);
    return {on, norm(block_.centre - on.point)};
}

/// Tells whether the surface comes nearer to the centre beyond the edge or corner in which a triangle is nearest, or as
/// near by a triangle that counts in its place: then it is no place where the ball touches, or that one's.
bool GroundMeeting::goes_on_nearer(std::int32_t triangle, const NearestOn& here) const {
    const auto is_nearer = [&](std::int32_t other) {
        if (other < 0 || other == triangle) {
            return false;
        }
        const NearestOn there = nearest_on(other);
        const double less = here.distance - there.distance;
        const bool counts = there.on.feature == geometry::TriangleFeature::face || other < triangle;
        return less > same * block_.size || (less > -same * block_.size && counts);
    };
    const auto corner = static_cast<std::size_t>(here.on.corner);
    switch (here.on.feature) {
        case geometry::TriangleFeature::face:
            return false;
        case geometry::TriangleFeature::edge:
            return is_nearer(features_.across(features_.edges_of(triangle)[corner], triangle));
        case geometry::TriangleFeature::corner:
            break;
    }
    const auto fan = features_.fan(mesh_.corners[at(triangle)][corner]);
    return std::any_of(fan.begin(), fan.end(), [&](std::int32_t e) {
        return is_nearer(features_.edge(e).left) || is_nearer(features_.edge(e).right);
    });
}

void GroundMeeting::find_round(const BlockContactHistory& history, std::size_t begin, std::size_t end,
                               std::vector<BlockContact>& found) {
    first_ = found.size();
    found_ = &found;
    for (const std::int32_t t : near_.triangles) {
        const NearestOn here = nearest_on(t);
        const Vec3 up = block_.centre - here.on.point;
        if (here.distance > block_.size + reach_ || !(dot(features_.normal(t), up) > 0) || goes_on_nearer(t, here)) {
            continue;
        }
        const Vec3 n = up / here.distance;
        const Vec3 tip = block_.centre - transpose_times(scene_.turn, farthest_along(scene_.round, scene_.turn * n));
        const double gap = dot(n, tip - here.on.point);
        if (gap > reach_) {
            continue;
        }
        for (std::size_t side = 0; side < (scene_.half > 0 ? 2U : 1U); ++side) {  // both ends of a disc
            const Vec3 along{0, 0, scene_.half * (side == 0 ? -1 : 1)};
            add(GroundKind::corner, side, t, n, tip - gap * n + along, tip + along);
        }
    }
    const auto own = std::span(found).subspan(first_);
    std::sort(own.begin(), own.end(),
              [](const BlockContact& p, const BlockContact& q) { return p.feature < q.feature; });
    take_over(history, begin, end, own);
}

}  // namespace riprap::solid::affine
