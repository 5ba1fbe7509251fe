// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "riprap/contact/narrowphase/common_plane.hpp"

namespace riprap::contact {

/// A point in a common plane [m].
struct PlanePoint {
    double x, y;
};
inline double cross(const PlanePoint& a, const PlanePoint& b) { return a.x * b.y - a.y * b.x; }
inline PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) { return {a.x - b.x, a.y - b.y}; }
inline PlanePoint operator+(const PlanePoint& a, const PlanePoint& b) { return {a.x + b.x, a.y + b.y}; }
inline PlanePoint operator*(double s, const PlanePoint& a) { return {s * a.x, s * a.y}; }
inline double dot(const PlanePoint& a, const PlanePoint& b) { return a.x * b.x + a.y * b.y; }

inline constexpr int most_touching = 32;

/// The corners of a body that touch a common plane, as a convex set in it: one point, a segment, or a polygon
/// counter-clockwise about the normal.
struct TouchingSet {
    int count{0};
    int touching{0};  ///< all corners that touch, those inside of the set or on a side of it included
    std::array<std::int32_t, most_touching> vertex;
    std::array<PlanePoint, most_touching> point;
};

/// Axes in the plane across n: x cross y = n.
struct PlaneAxes {
    Vec3 origin, x, y;
    PlanePoint project(const Vec3& p) const {
        const Vec3 d = p - origin;
        return {riprap::dot(d, x), riprap::dot(d, y)};
    }
};
PlaneAxes axes_across(const Vec3& normal, const Vec3& origin);

/// Returns the face of a hull that turns most towards `outward`. Not for half-spaces.
std::size_t facing_face(const PlacedHull& hull, const Vec3& outward);

/// Says how far below the farthest corner along a direction others count as touching [m].
struct Touch {
    double of_corner;  ///< of any
    double of_face;    ///< of those of the face that turns most towards the direction; counts where larger
};

/// Corners of `hull` that touch along `outward`, reduced to their convex hull in the plane.
TouchingSet touching_set(const PlacedHull& hull, const Vec3& outward, const Touch& touch, const PlaneAxes& axes);

/// A corner of the intersection of two touching sets, and what makes it: a corner of A (b_from < 0), a corner of B
/// (a_from < 0), or the crossing of an edge of A with one of B. Numbers count within the sets.
struct CommonCorner {
    PlanePoint point;
    std::int32_t a_from, a_to, b_from, b_to;
};
inline constexpr int most_corners = 48;
struct CommonPolygon {
    int count{0};
    std::array<CommonCorner, most_corners> corner;
};

/// Intersects two convex sets of which at least one is a polygon, points within `slack` of an edge included [m].
CommonPolygon intersect(const TouchingSet& a, const TouchingSet& b, double slack);

/// Tells whether a corner of `subject` lies inside of `by`, a polygon, as intersect() sees it: it is a corner of the
/// intersection then.
bool has_corner_inside(const TouchingSet& subject, const TouchingSet& by, double slack);

}  // namespace riprap::contact
