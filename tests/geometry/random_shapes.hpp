// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "riprap/core/quat.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry::testing {

inline double uniform(std::mt19937_64& random, double low = -1, double high = 1) {
    return low + (high - low) * 0x1p-53 * static_cast<double>(random() >> 11);
}

inline Vec3 random_point(std::mt19937_64& random) { return {uniform(random), uniform(random), uniform(random)}; }

inline Vec3 random_direction(std::mt19937_64& random) {
    for (;;) {
        const Vec3 x = random_point(random);
        const double length = norm(x);
        if (length > 0.1 && length < 1) {
            return x / length;
        }
    }
}

inline Quat random_orientation(std::mt19937_64& random) {
    return from_rotation_vector(uniform(random, 0, 3.1) * random_direction(random));
}

/// Convex hull by trying every triangle: O(n^4), for a dozen points in general position. The oracle of the tests.
inline Polyhedron brute_force_hull(const std::vector<Vec3>& points) {
    Polyhedron hull{points, {}, {}};
    const auto n = static_cast<std::int32_t>(points.size());
    const auto at = [&](std::int32_t i) { return points[static_cast<std::size_t>(i)]; };
    for (std::int32_t i = 0; i < n; ++i) {
        for (std::int32_t j = i + 1; j < n; ++j) {
            for (std::int32_t k = j + 1; k < n; ++k) {
                const Vec3 normal = cross(at(j) - at(i), at(k) - at(i));
                bool some_above = false, some_below = false;
                for (std::int32_t l = 0; l < n; ++l) {
                    if (l != i && l != j && l != k) {
                        (dot(normal, at(l) - at(i)) > 0 ? some_above : some_below) = true;
                    }
                }
                if (some_above != some_below) {
                    hull.faces.push_back(some_below ? std::vector{i, j, k} : std::vector{i, k, j});
                }
            }
        }
    }
    return hull;
}

/// A hull of `count` points on an ellipsoid with semi-axes `axes`.
inline Polyhedron random_block(std::mt19937_64& random, int count, const Vec3& axes = {1, 1, 1}) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const Vec3 d = random_direction(random);
        points.push_back({axes.x * d.x, axes.y * d.y, axes.z * d.z});
    }
    return brute_force_hull(points);
}

}  // namespace riprap::geometry::testing
