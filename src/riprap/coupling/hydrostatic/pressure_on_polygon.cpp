// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/hydrostatic/pressure_on_polygon.hpp"

#include <vector>

namespace riprap::coupling {

namespace {

/// Keeps the part of a convex polygon with depth >= 0, depth = level - up . r.
std::vector<Vec3> below_level(std::span<const Vec3> corners, const Vec3& up, double level) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double depth_a = level - dot(up, a), depth_b = level - dot(up, b);
        if (depth_a >= 0) {
            kept.push_back(a);
        }
        if ((depth_a > 0 && depth_b < 0) || (depth_a < 0 && depth_b > 0)) {
            kept.push_back(a + (depth_a / (depth_a - depth_b)) * (b - a));
        }
    }
    return kept;
}

}  // namespace

PressureIntegral pressure_on_polygon(std::span<const Vec3> corners, const Vec3& up, double level, double weight) {
    const std::vector<Vec3> wet = below_level(corners, up, level);
    PressureIntegral sum;
    for (std::size_t k = 2; k < wet.size(); ++k) {
        const Vec3 &a = wet[0], &b = wet[k - 1], &c = wet[k];
        const double area = 0.5 * norm(cross(b - a, c - a));
        const double p = weight * (level - dot(up, a)), q = weight * (level - dot(up, b)),
                     r = weight * (level - dot(up, c));
        sum.of_pressure += area / 3 * (p + q + r);
        sum.of_moment += (area / 12) * ((p + q + r) * (a + b + c) + p * a + q * b + r * c);
    }
    return sum;
}

Vec3 normal_of(std::span<const Vec3> corners) {
    Vec3 sum{};
    for (std::size_t k = 2; k < corners.size(); ++k) {
        sum += cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
    }
    const double length = norm(sum);
    return length > 0 ? sum / length : Vec3{};
}

}  // namespace riprap::coupling
