// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/core/vec3.hpp"

namespace riprap::geometry {

/// Part of a triangle that is nearest to a point: its face, an edge (named by the corner before it) or a corner.
enum class TriangleFeature : std::uint8_t { face, edge, corner };

/// Nearest point of a triangle.
struct TrianglePoint {
    Vec3 point;  ///< [m]
    TriangleFeature feature;
    std::int32_t corner;  ///< of the feature: the corner, or the first of the edge, 0 to 2
};

/// Nearest point of the triangle (a, b, c) to x, by the regions of its corners, edges and face [Ericson2005, 5.1.5].
inline TrianglePoint nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& x) {
    const Vec3 ab = b - a, ac = c - a, ax = x - a;
    const double d1 = dot(ab, ax), d2 = dot(ac, ax);
    if (d1 <= 0 && d2 <= 0) {
        return {a, TriangleFeature::corner, 0};
    }
    const Vec3 bx = x - b;
    const double d3 = dot(ab, bx), d4 = dot(ac, bx);
    if (d3 >= 0 && d4 <= d3) {
        return {b, TriangleFeature::corner, 1};
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        return {a + (d1 / (d1 - d3)) * ab, TriangleFeature::edge, 0};
    }
    const Vec3 cx = x - c;
    const double d5 = dot(ab, cx), d6 = dot(ac, cx);
    if (d6 >= 0 && d5 <= d6) {
        return {c, TriangleFeature::corner, 2};
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        return {a + (d2 / (d2 - d6)) * ac, TriangleFeature::edge, 2};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        return {b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b), TriangleFeature::edge, 1};
    }
    const double sum = va + vb + vc;
    return {a + (vb / sum) * ab + (vc / sum) * ac, TriangleFeature::face, 0};
}

}  // namespace riprap::geometry
