// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/fluid/particle/domain.hpp"

namespace riprap::fluid {

/// @throws CaseError  where a period is shorter than two reaches, so that a particle could meet another twice
void check_periods(const Domain& domain, double reach);

/// Points binned in cells at least one reach wide. The grid covers the points wherever they are; along periodic axes it
/// covers one period. Its memory is bounded by the number of points: cells grow when the points lie far apart. Points
/// that are not finite are nobody's neighbours.
class CellGrid {
 public:
    /// @param reach  distance within which neighbours are asked for [m], > 0
    /// @throws CaseError  see check_periods
    void build(std::span<const Vec3> points, const Domain& domain, double reach);

    /// f(j) for all points within `reach` of x and some beyond, cell by cell, ascending within a cell.
    template <class F>
    void for_each_near(const Vec3& x, const F& f) const {
        std::array<CellRange, 3> range;
        for (int axis = 0; axis < 3; ++axis) {
            range[static_cast<std::size_t>(axis)] = cells_around(x[axis], axis);
        }
        for (std::int64_t a = range[2].first; a < range[2].first + range[2].count; ++a) {
            for (std::int64_t b = range[1].first; b < range[1].first + range[1].count; ++b) {
                for (std::int64_t c = range[0].first; c < range[0].first + range[0].count; ++c) {
                    const std::int64_t cell =
                        ((a % axes_[2].cells) * axes_[1].cells + b % axes_[1].cells) * axes_[0].cells +
                        c % axes_[0].cells;
                    for (std::int32_t k = start_[static_cast<std::size_t>(cell)];
                         k < start_[static_cast<std::size_t>(cell) + 1]; ++k) {
                        f(static_cast<std::int64_t>(points_[static_cast<std::size_t>(k)]));
                    }
                }
            }
        }
    }

 private:
    struct Axis {
        double low{0}, period{0};  ///< [m]; period 0: not periodic
        double per_metre{1};       ///< cells per metre
        std::int64_t cells{1};
    };
    /// Cells first, first + 1, ... (modulo the number of cells)
    struct CellRange {
        std::int64_t first, count;
    };

    CellRange cells_around(double x, int axis) const;
    std::int64_t cell_of(const Vec3& x) const;

    std::array<Axis, 3> axes_;
    double reach_{0};
    std::vector<std::int32_t> start_;    ///< per cell, one more at the end
    std::vector<std::uint32_t> points_;  ///< indices, cell by cell
    std::vector<std::uint64_t> keys_, key_buffer_;
    std::vector<std::uint32_t> value_buffer_;
};

/// x_i - x_j to the nearest image of x_j [m].
class NearestImage {
 public:
    explicit NearestImage(const Domain& domain) {
        for (int axis = 0; axis < domain.dimension; ++axis) {
            if (domain.is_periodic[static_cast<std::size_t>(axis)]) {
                period_[axis] = domain.high[axis] - domain.low[axis];
                per_period_[axis] = 1 / period_[axis];
            }
        }
    }
    Vec3 operator()(const Vec3& difference) const {
        Vec3 d = difference;
        for (int axis = 0; axis < 3; ++axis) {
            d[axis] -= period_[axis] * std::nearbyint(d[axis] * per_period_[axis]);
        }
        return d;
    }

 private:
    Vec3 period_{}, per_period_{};
};

/// The smallest box around all finite points; low > high when there is none.
struct Box {
    Vec3 low, high;
};
Box box_of(std::span<const Vec3> points);

}  // namespace riprap::fluid
