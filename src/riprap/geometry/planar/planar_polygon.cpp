// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/planar/planar_polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"

namespace riprap::geometry {

PolygonMoments moments_of(std::span<const Vec2> corners) {
    PolygonMoments m;
    if (corners.empty()) {
        return m;
    }
    const Vec2 origin = corners.front();
    double sx = 0, sy = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 p = corners[k] - origin, q = corners[(k + 1) % corners.size()] - origin;
        const double a = cross(p, q);
        m.area += a / 2;
        sx += a * (p.x + q.x) / 6;
        sy += a * (p.y + q.y) / 6;
        m.xx += a * (p.x * p.x + p.x * q.x + q.x * q.x) / 12;
        m.yy += a * (p.y * p.y + p.y * q.y + q.y * q.y) / 12;
        m.xy += a * (2 * p.x * p.y + p.x * q.y + q.x * p.y + 2 * q.x * q.y) / 24;
    }
    if (m.area != 0) {
        const Vec2 center = (1 / m.area) * Vec2{sx, sy};
        m.xx -= center.x * sx;
        m.yy -= center.y * sy;
        m.xy -= center.x * sy;
        m.centroid = origin + center;
    }
    return m;
}

bool is_inside(std::span<const Vec2> corners, const Vec2& point) {
    bool inside = false;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 a = corners[k] - point, b = corners[(k + 1) % corners.size()] - point;
        if (cross(a, b) == 0 && dot(a, b) <= 0) {
            return true;  // on the edge
        }
        if ((a.y > 0) != (b.y > 0) && (cross(a, b) > 0) == (b.y > a.y)) {
            inside = !inside;
        }
    }
    return inside;
}

namespace {

/// Tells whether the segments a-b and c-d have a point in common.
bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
    const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
    if (((c_side > 0) != (d_side > 0)) && ((a_side > 0) != (b_side > 0)) && c_side != 0 && d_side != 0 && a_side != 0 &&
        b_side != 0) {
        return true;
    }
    const auto lies_on = [](const Vec2& p, const Vec2& q, double side, const Vec2& r) {
        return side == 0 && dot(r - p, r - q) <= 0;
    };
    return lies_on(a, b, c_side, c) || lies_on(a, b, d_side, d) || lies_on(c, d, a_side, a) || lies_on(c, d, b_side, b);
}

}  // namespace

Outcome<Polygon> make_polygon(std::span<const Vec2> corners, double sliver) {
    Polygon polygon;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (!std::isfinite(corners[k].x) || !std::isfinite(corners[k].y)) {
            return GeometryProblem{fmt::format("corner {} is not finite", k), "finite coordinates"};
        }
        if (polygon.empty() || !(corners[k] == polygon.back())) {
            polygon.push_back(corners[k]);
        }
    }
    while (polygon.size() > 1 && polygon.front() == polygon.back()) {
        polygon.pop_back();
    }
    const std::size_t n = polygon.size();
    if (n < 3) {
        return GeometryProblem{fmt::format("a polygon of {} different corners", n), "at least three"};
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 2; j < n; ++j) {
            if ((j + 1) % n != i && segments_meet(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n])) {
                return GeometryProblem{fmt::format("edges {} and {} of the polygon meet", i, j),
                                       "an outline that neither crosses nor touches itself"};
            }
        }
    }
    const PolygonMoments moments = moments_of(polygon);
    const auto [left, right] =
        std::minmax_element(polygon.begin(), polygon.end(), [](auto& a, auto& b) { return a.x < b.x; });
    const auto [low, high] =
        std::minmax_element(polygon.begin(), polygon.end(), [](auto& a, auto& b) { return a.y < b.y; });
    const double extent = std::max(right->x - left->x, high->y - low->y);
    if (!(std::abs(moments.area) > sliver * extent * extent)) {
        return GeometryProblem{
            fmt::format("a sliver: area {:.3g} m^2 of a polygon {:.3g} m long", std::abs(moments.area), extent),
            fmt::format("an area above {:.3g} m^2", sliver * extent * extent)};
    }
    if (moments.area < 0) {
        std::reverse(polygon.begin(), polygon.end());
    }
    return polygon;
}

}  // namespace riprap::geometry
