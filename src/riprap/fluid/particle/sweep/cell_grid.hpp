// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/config.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"
#include "riprap/fluid/particle/sweep/math.hpp"

namespace riprap::fluid {

/// @throws CaseError  where a period is shorter than two reaches, so that a particle could meet another twice
void check_periods(const Domain& domain, double reach);

/// View of a CellGrid for loops over neighbours: plain pointers, for host and device.
struct CellGridView {
    struct Axis {
        double low{0}, period{0};  ///< [m]; period 0: not periodic
        double per_metre{1};       ///< cells per metre
        std::int64_t cells{1};
    };
    /// Cells first, first + 1, ... (modulo the number of cells)
    struct CellRange {
        std::int64_t first, count;
    };

    Axis axes[3];
    double reach;                 ///< [m]
    const std::int32_t* start;    ///< per cell, one more at the end
    const std::uint32_t* points;  ///< indices, cell by cell

    /// f(j) for all points within `reach` of x and some beyond, cell by cell, ascending within a cell.
    template <class F>
    RIPRAP_HD void for_each_near(const Vec3& x, F&& f) const {
        any_near(x, [&f](std::int64_t j) {
            f(j);
            return false;
        });
    }
    /// Tells whether is(j) holds for any of these points; asks in the same order, up to the first that it holds for.
    template <class Is>
    RIPRAP_HD bool any_near(const Vec3& x, Is&& is) const {
        return any_run_near(x, [&](std::int32_t begin, std::int32_t end) {
            for (std::int32_t k = begin; k < end; ++k) {
                if (is(static_cast<std::int64_t>(points[k]))) {
                    return true;
                }
            }
            return false;
        });
    }
    /// f(begin, end) for the places of these points in `points`, in runs of cells that follow each other.
    template <class F>
    RIPRAP_HD void for_each_run_near(const Vec3& x, F&& f) const {
        any_run_near(x, [&f](std::int32_t begin, std::int32_t end) {
            f(begin, end);
            return false;
        });
    }
    /// Number of the cell of a point that is finite.
    RIPRAP_HD std::int64_t cell_of(const Vec3& x) const {
        std::int64_t cell = 0;
        for (int axis = 2; axis >= 0; --axis) {
            const Axis& a = axes[axis];
            double from_low = x[axis] - a.low;
            if (a.period > 0) {
                from_low -= a.period * std::floor(from_low / a.period);
            }
            const auto along = a.cells == 1 ? 0 : static_cast<std::int64_t>(from_low * a.per_metre);
            cell = cell * a.cells + (along < 0 ? 0 : along < a.cells ? along : a.cells - 1);
        }
        return cell;
    }
    RIPRAP_HD std::int64_t cell_count() const { return axes[0].cells * axes[1].cells * axes[2].cells; }

 private:
    template <class Is>
    RIPRAP_HD bool any_run_near(const Vec3& x, Is&& is) const {
        const CellRange rx = cells_around(x.x, axes[0]), ry = cells_around(x.y, axes[1]),
                        rz = cells_around(x.z, axes[2]);
        const std::int64_t first = rx.first % axes[0].cells, beyond = first + rx.count - axes[0].cells;
        for (std::int64_t a = rz.first; a < rz.first + rz.count; ++a) {
            for (std::int64_t b = ry.first; b < ry.first + ry.count; ++b) {
                const std::int32_t* const row =
                    start + ((a % axes[2].cells) * axes[1].cells + b % axes[1].cells) * axes[0].cells;
                if (is(row[first], row[beyond > 0 ? axes[0].cells : first + rx.count])) {
                    return true;
                }
                if (beyond > 0 && is(row[0], row[beyond])) {
                    return true;
                }
            }
        }
        return false;
    }
    // Inlined everywhere: files of kernels, which fuse products with sums, and others would each have their own.
    [[gnu::always_inline]] RIPRAP_HD CellRange cells_around(double x, const Axis& a) const {
        if (a.cells == 1) {
            return {0, 1};
        }
        double from_low = x - a.low;
        if (a.period > 0) {
            from_low -= a.period * std::floor(from_low / a.period);
        }
        const double first = std::floor((from_low - reach) * a.per_metre);
        const double last = std::floor((from_low + reach) * a.per_metre);
        const auto cells = static_cast<double>(a.cells);
        if (a.period > 0) {
            if (!(last - first + 1 < cells)) {
                return {0, a.cells};
            }
            return {static_cast<std::int64_t>(first) + a.cells, static_cast<std::int64_t>(last - first) + 1};
        }
        const double low = max(first, 0.0), high = min(last, cells - 1);
        if (!(low <= high)) {
            return {0, 0};
        }
        return {static_cast<std::int64_t>(low), static_cast<std::int64_t>(high - low) + 1};
    }
};

/// Finds the cell of a particle, as a key to sort by; those that are not finite go behind the last one.
struct FindCell {
    CellGridView cells;
    const Vec3* position;
    std::uint64_t* key;
    std::uint32_t* order;

    RIPRAP_HD void operator()(std::int64_t i) const {
        const Vec3& x = position[i];
        key[i] = static_cast<std::uint64_t>(is_finite(x) ? cells.cell_of(x) : cells.cell_count());
        order[i] = static_cast<std::uint32_t>(i);
    }
};

/// Finds the first particle of a cell among sorted keys.
struct FindStart {
    const std::uint64_t* key;
    std::int64_t count;
    std::int32_t* start;

    RIPRAP_HD void operator()(std::int64_t cell) const {
        std::int64_t low = 0, high = count;
        while (low < high) {
            const std::int64_t middle = (low + high) / 2;
            if (key[middle] < static_cast<std::uint64_t>(cell)) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        start[cell] = static_cast<std::int32_t>(low);
    }
};

/// The smallest box around all finite points; low > high when there is none.
struct Box {
    Vec3 low, high;
};
Box box_of(std::span<const Vec3> points);
/// The smallest box around all finite points of both.
Box box_of(std::span<const Vec3> one, std::span<const Vec3> other);

/// Lays out cells for so many points in a box, at least `edge` wide each [m], or wider where that makes far more cells
/// than points. The view has no points yet.
/// @param reach  distance within which neighbours are asked for [m], > 0
/// @throws CaseError  see check_periods
CellGridView lay_out_cells(const Box& box, std::size_t count, const Domain& domain, double reach, double edge);

/// Points binned in cells at least one reach wide. The grid covers the points wherever they are; along periodic axes it
/// covers one period. Its memory is bounded by the number of points: cells grow when the points lie far apart. Points
/// that are not finite are nobody's neighbours.
class CellGrid {
 public:
    /// @param reach  distance within which neighbours are asked for [m], > 0
    /// @throws CaseError  see check_periods
    void build(std::span<const Vec3> points, const Domain& domain, double reach);

    CellGridView view() const {
        CellGridView view = cells_;
        view.start = start_.data();
        view.points = points_.data();
        return view;
    }

    template <class F>
    void for_each_near(const Vec3& x, F&& f) const {
        view().for_each_near(x, f);
    }

 private:
    CellGridView cells_{};
    std::vector<std::int32_t> start_;
    std::vector<std::uint32_t> points_;
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

}  // namespace riprap::fluid
