// SPDX-License-Identifier: Apache-2.0
// Corners of a block on triangles of the ground.
#include <cmath>

#include "riprap/geometry/surface/triangle.hpp"
#include "riprap/solid/affine/ground_meeting.hpp"

namespace riprap::solid::affine {

bool GroundMeeting::has_corner(std::size_t v, const Vec3& normal) const {
    const std::uint64_t name = ground_feature(GroundKind::corner, v, 0) >> 32;
    const Vec3 n = (scene_.is_ground_first ? 1.0 : -1.0) * (scene_.turn * normal);
    return std::any_of(
        found_->begin() + static_cast<std::ptrdiff_t>(first_), found_->end(), [&](const BlockContact& c) {
            return c.feature >> 32 == name && norm_squared(c.normal - n) < geometry::flat_turn * geometry::flat_turn;
        });
}

void GroundMeeting::add_corner(std::size_t v, std::int32_t triangle, const Floor& floor) {
    if (!has_corner(v, floor.normal)) {
        const Vec3& x = block_.vertices[v];
        add(GroundKind::corner, v, triangle, floor.normal, x - floor.gap(x) * floor.normal, x);
    }
}

/// Adds the other sides of the clefts around a triangle, which push the corner as well.
void GroundMeeting::add_clefts(std::size_t v, std::int32_t triangle) {
    for (const std::int32_t e : features_.edges_of(triangle)) {
        if (features_.edge(e).kind == geometry::EdgeKind::cleft) {
            const std::int32_t other = features_.across(e, triangle);
            const Floor floor = floor_of(other);
            if (floor.is_met && floor.gap(block_.vertices[v]) <= floor.highest) {
                add_corner(v, other, floor);
            }
        }
    }
}

void GroundMeeting::add_corners() {
    for (const std::int32_t t : near_.triangles) {
        if (!box_of(t).meets(block_.box, reach_)) {
            continue;
        }
        const Floor floor = floor_of(t);
        for (std::size_t v = 0; floor.is_met && v < block_.vertices.size(); ++v) {
            const Vec3& x = block_.vertices[v];
            const double gap = floor.gap(x);
            if (gap > floor.highest) {
                continue;
            }
            if (features_.is_in_cell(mesh_, t, x)) {
                misses_[v].has_cell = true;
                add_corner(v, t, floor);
                add_clefts(v, t);
            } else if (gap < 0) {
                remember_miss(v, t, gap);
            }
        }
    }
    for (std::size_t v = 0; v < misses_.size(); ++v) {
        if (!misses_[v].has_cell && misses_[v].triangle >= 0) {
            add_corner(v, misses_[v].triangle, floor_of(misses_[v].triangle));
        }
    }
}

/// Keeps the triangle nearest to a corner that is below a point where cells leave a gap.
void GroundMeeting::remember_miss(std::size_t v, std::int32_t t, double gap) {
    const Vec3& x = block_.vertices[v];
    const auto on = geometry::nearest_on_triangle(mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2), x);
    const double squared = norm_squared(x - on.point);
    Miss& miss = misses_[v];
    const bool is_near = squared <= 4 * gap * gap && norm(on.point - block_.centre) <= block_.size + reach_;
    if (is_near && (miss.triangle < 0 || squared < miss.squared)) {
        miss.squared = squared;
        miss.triangle = t;
    }
}

}  // namespace riprap::solid::affine
