// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "riprap/core/vec3.hpp"

namespace riprap::contact::plain {

/// A plane as the half-space { x : gap(x) >= 0 } with gap(x) = offset - gradient . x.
/// gradient need not have length 1: the bisector between two cells of a field is of this form too.
struct Plane {
    Vec3 gradient;
    double offset;
    RIPRAP_HD double gap(const Vec3& x) const { return offset - dot(gradient, x); }
};

/// A convex polygon in space with room for `Capacity` corners.
template <int Capacity>
struct Polygon {
    int size{0};
    bool overflows{false};  ///< a clip needed more room; the polygon is then incomplete
    Vec3 x[Capacity];

    RIPRAP_HD void push(const Vec3& point) {
        if (size == Capacity) {
            overflows = true;
            return;
        }
        x[size++] = point;
    }
};

enum class Cut {
    inside,    ///< at least a part is left
    empty,     ///< nothing is left
    coplanar,  ///< the whole polygon lies in the plane; nothing was cut
};

/// Cuts a convex polygon to the side of a plane where gap >= 0 [Sutherland1974]. Corners with |gap| <= tolerance count
/// as lying in the plane, so that round-off makes no slivers.
template <int Capacity>
RIPRAP_HD Cut clip(Polygon<Capacity>& polygon, const Plane& plane, double tolerance) {
    const auto gap_at = [&](int i) {
        const double s = plane.gap(polygon.x[i]);
        return s < -tolerance || s > tolerance ? s : 0.0;
    };
    bool any_inside = false, any_outside = false;
    for (int i = 0; i < polygon.size; ++i) {
        const double s = gap_at(i);
        any_inside = any_inside || s > 0;
        any_outside = any_outside || s < 0;
    }
    if (!any_inside) {
        if (any_outside || polygon.size == 0) {
            polygon.size = 0;
            return Cut::empty;
        }
        return Cut::coplanar;
    }
    if (!any_outside) {
        return Cut::inside;
    }
    Polygon<Capacity> kept;
    for (int i = 0; i < polygon.size; ++i) {
        const int k = i + 1 < polygon.size ? i + 1 : 0;
        const double si = gap_at(i), sk = gap_at(k);
        if (si >= 0) {
            kept.push(polygon.x[i]);
        }
        if ((si > 0 && sk < 0) || (si < 0 && sk > 0)) {
            kept.push(polygon.x[i] + (si / (si - sk)) * (polygon.x[k] - polygon.x[i]));
        }
    }
    kept.overflows = kept.overflows || polygon.overflows;
    polygon = kept;
    return polygon.size < 3 ? Cut::empty : Cut::inside;
}

/// A square of half side `radius` in a plane, centred on the foot of `centre`, winding counter-clockwise seen from the
/// side that the gradient points to.
template <int Capacity>
RIPRAP_HD Polygon<Capacity> square_in(const Plane& plane, const Vec3& centre, double radius) {
    const double length = norm(plane.gradient);
    const Vec3 n = plane.gradient / length;
    const Vec3 foot = centre + (plane.gap(centre) / length) * n;
    const double ax = std::fabs(n.x), ay = std::fabs(n.y), az = std::fabs(n.z);
    const Vec3 axis = ax <= ay && ax <= az ? Vec3{1, 0, 0} : ay <= az ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 u = radius * normalized(cross(axis, n));
    const Vec3 v = cross(n, u);
    Polygon<Capacity> square;
    square.push(foot + u + v);
    square.push(foot - u + v);
    square.push(foot - u - v);
    square.push(foot + u - v);
    return square;
}

/// Exact integrals of a linear function p over a polygon with unit normal n: over a triangle of area a
///
///     int p dS = a/3 (p1+p2+p3),    int p x dS = a/12 [ (p1+p2+p3)(x1+x2+x3) + p1 x1 + p2 x2 + p3 x3 ].
struct LinearIntegral {
    double area{0};     ///< [m^2]
    double sum{0};      ///< int p dS
    Vec3 first{};       ///< int p x dS
    double largest{0};  ///< of p at the corners, at least 0
};

template <int Capacity>
RIPRAP_HD LinearIntegral integrate(const Polygon<Capacity>& polygon, const Vec3& normal, const Plane& field,
                                   const Vec3& reference) {
    LinearIntegral total;
    for (int i = 0; i < polygon.size; ++i) {
        const double p = field.gap(polygon.x[i]);
        total.largest = p > total.largest ? p : total.largest;
    }
    for (int i = 2; i < polygon.size; ++i) {
        const Vec3 x1 = polygon.x[0] - reference, x2 = polygon.x[i - 1] - reference, x3 = polygon.x[i] - reference;
        const double p1 = field.gap(polygon.x[0]), p2 = field.gap(polygon.x[i - 1]), p3 = field.gap(polygon.x[i]);
        const double area = 0.5 * dot(normal, cross(x2 - x1, x3 - x1));
        const double sum = p1 + p2 + p3;
        total.area += area;
        total.sum += area * sum / 3;
        total.first += (area / 12) * (sum * (x1 + x2 + x3) + p1 * x1 + p2 * x2 + p3 * x3);
    }
    return total;
}

}  // namespace riprap::contact::plain
