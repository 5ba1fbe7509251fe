// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace riprap::fluid::grid {

/// Volume of a unit cube below a plane: of the points with m.x <= d, where m_a >= 0 and m_0 + m_1 + m_2 = 1
/// [Scardovelli2000]. d and 1 - d give shares that add up to 1.
inline double volume_below(std::array<double, 3> m, double d) {
    if (d <= 0) {
        return 0;
    }
    if (d >= 1) {
        return 1;
    }
    if (m[0] > m[1]) {
        std::swap(m[0], m[1]);
    }
    if (m[1] > m[2]) {
        std::swap(m[1], m[2]);
    }
    if (m[0] > m[1]) {
        std::swap(m[0], m[1]);
    }
    const double c = std::min(d, 1 - d), m12 = m[0] + m[1];
    double volume = 0;
    if (c < m[0]) {
        volume = c * c * c / (6 * m[0] * m[1] * m[2]);
    } else if (c < m[1]) {
        volume = (c * (c - m[0]) + m[0] * m[0] / 3) / (2 * m[1] * m[2]);
    } else if (c < std::min(m12, m[2])) {
        volume = (c * c * (3 * m12 - c) + m[0] * m[0] * (m[0] - 3 * c) + m[1] * m[1] * (m[1] - 3 * c)) /
                 (6 * m[0] * m[1] * m[2]);
    } else if (m12 <= m[2]) {
        volume = (c - 0.5 * m12) / m[2];
    } else {
        volume = (c * c * (3 - 2 * c) + m[0] * m[0] * (m[0] - 3 * c) + m[1] * m[1] * (m[1] - 3 * c) +
                  m[2] * m[2] * (m[2] - 3 * c)) /
                 (6 * m[0] * m[1] * m[2]);
    }
    return d <= 0.5 ? volume : 1 - volume;
}

/// The plane constant d for which volume_below(m, d) = volume, to round-off, by safeguarded Newton steps on a function
/// that increases.
inline double plane_constant(const std::array<double, 3>& m, double volume) {
    if (volume <= 0) {
        return 0;
    }
    if (volume >= 1) {
        return 1;
    }
    double low = 0, high = 1, d = 0.5;
    constexpr double step = 1e-7;
    for (int i = 0; i < 60; ++i) {
        const double error = volume_below(m, d) - volume;
        (error > 0 ? high : low) = d;
        if (std::abs(error) < 1e-15) {
            break;
        }
        const double slope = (volume_below(m, d + step) - volume_below(m, d - step)) / (2 * step);
        const double newton = slope > 1e-8 ? d - error / slope : -1;
        d = newton > low && newton < high ? newton : 0.5 * (low + high);
        if (high - low < 1e-16) {
            break;
        }
    }
    return d;
}

/// A plane of the surface in a cell: water where n.x <= d, x from -1/2 to 1/2 along each axis in cell widths, n
/// pointing out of the water with |n_0| + |n_1| + |n_2| = 1.
struct CellPlane {
    std::array<double, 3> n{};
    double d{0};
};

/// Places the plane of given normal so that it holds the fraction.
inline CellPlane place_plane(const std::array<double, 3>& n, double fraction) {
    const std::array<double, 3> m{std::abs(n[0]), std::abs(n[1]), std::abs(n[2])};
    return {n, plane_constant(m, fraction) - 0.5};
}

/// Water fraction of the slab of a cell between the places low and high along an axis, -1/2 to 1/2 [-].
inline double slab_fraction(const CellPlane& plane, int axis, double low, double high) {
    const auto a = static_cast<std::size_t>(axis);
    // In the slab's own coordinates the normal along the axis is shortened and the constant shifted.
    std::array<double, 3> m{std::abs(plane.n[0]), std::abs(plane.n[1]), std::abs(plane.n[2])};
    const double middle = 0.5 * (low + high);
    m[a] *= high - low;
    const double sum = m[0] + m[1] + m[2];
    const double d = plane.d - plane.n[a] * middle + 0.5 * sum;
    if (sum < 1e-14) {
        return d > 0 ? 1 : 0;
    }
    for (double& c : m) {
        c /= sum;
    }
    return volume_below(m, d / sum);
}

}  // namespace riprap::fluid::grid
