// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

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
    } else if (m12 <= m[2] && c >= m12) {
        volume = (c - 0.5 * m12) / m[2];
    } else {  // over the shortest edge: nothing cancels where that is short
        const double second = c - m[1], third = std::max(0.0, c - m[2]);
        volume = (3 * c * (c - m[0]) + m[0] * m[0] - (second * second * second + third * third * third) / m[0]) /
                 (6 * m[1] * m[2]);
    }
    return d <= 0.5 ? volume : 1 - volume;
}

/// The plane constant d for which volume_below(m, d) = volume: in closed form where the section is a triangle or, up to
/// one edge, a trapezium, else by Newton's steps from above, of which each stays above, as the volume is convex up to
/// one half [Scardovelli2000].
inline double plane_constant(std::array<double, 3> m, double volume) {
    if (volume <= 0) {
        return 0;
    }
    if (volume >= 1) {
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
    const double v = std::min(volume, 1 - volume), m12 = m[0] + m[1];
    const double first = m[1] > 0 ? m[0] * m[0] / (6 * m[1] * m[2]) : 0;  // volume up to the first edge
    double d = 0.5;
    if (v < first) {
        d = std::cbrt(6 * m[0] * m[1] * m[2] * v);
    } else if (m[1] > 0 && v < first + (m[1] - m[0]) / (2 * m[2])) {
        d = 0.5 * (m[0] + std::sqrt(m[0] * m[0] + 8 * m[1] * m[2] * (v - first)));
    } else if (m12 <= m[2] && v >= 0.5 * m12 / m[2]) {
        d = v * m[2] + 0.5 * m12;
    } else {
        d = std::min(0.5, m12);
        for (int i = 0; i < 40; ++i) {
            // volume times six products over the shortest edge: nothing cancels where that is short
            const double second = d - m[1], third = std::max(0.0, d - m[2]);
            const double error = 3 * d * (d - m[0]) + m[0] * m[0] -
                                 (second * second * second + third * third * third) / m[0] - 6 * m[1] * m[2] * v;
            const double slope = 6 * d - 3 * m[0] - 3 * (second * second + third * third) / m[0];
            const double step = error / slope;
            d -= step;
            if (!(std::abs(step) > 1e-15)) {
                break;
            }
        }
    }
    return volume <= 0.5 ? d : 1 - d;
}

/// A plane of the surface in a cell: water where n.x <= d, x from -1/2 to 1/2 along each axis in cell widths, n
/// pointing out of the water with |n_0| + |n_1| + |n_2| = 1.
struct CellPlane {
    std::array<double, 3> n{};
    double d{0};
};

/// Planes of mixed cells, row after row.
struct CellPlanes {
    std::vector<std::int32_t> number;     ///< per cell; -1 = the cell was not mixed
    std::vector<std::int32_t> row_begin;  ///< of rows of cells
    std::vector<CellPlane> plane;

    /// Returns the plane of a cell; without direction, through its centre, where the cell was not mixed.
    const CellPlane& operator[](std::size_t cell) const {
        static constexpr CellPlane none{};
        return number[cell] < 0 ? none : plane[static_cast<std::size_t>(number[cell])];
    }
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
