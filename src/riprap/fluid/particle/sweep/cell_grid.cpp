// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep/cell_grid.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>

#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::fluid {

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
}  // namespace

void check_periods(const Domain& domain, double reach) {
    for (int axis = 0; axis < domain.dimension; ++axis) {
        const double period = domain.high[axis] - domain.low[axis];
        if (domain.is_periodic[static_cast<std::size_t>(axis)] && !(period >= 2 * reach)) {
            Diagnostic problem;
            problem.message = "the domain is periodic with a period of " + std::to_string(period) + " m";
            problem.allowed =
                "at least " + std::to_string(2 * reach) + " m, twice the distance at which particles act on each other";
            throw CaseError(std::move(problem));
        }
    }
}

namespace {

constexpr Box nothing{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};

Box join(const Box& a, const Box& b) {
    return {min(b.low, a.low), max(b.high, a.high)};  // a number that is none loses every comparison
}

/// Around points of which none is infinite, four at a time: x y z x y z x y z x y z in three vectors.
Box box_of_finite(std::span<const Vec3> points) {
    constexpr std::size_t side_by_side = 4;
    using Four [[gnu::vector_size(side_by_side * sizeof(double))]] = double;
    std::array<Four, 3> low, high;
    low.fill(Four{} + infinity);
    high.fill(Four{} - infinity);
    std::size_t i = 0;
    for (; i + side_by_side <= points.size(); i += side_by_side) {
        std::array<Four, 3> x;
        std::memcpy(x.data(), &points[i], sizeof x);
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = x[k] < low[k] ? x[k] : low[k];
            high[k] = x[k] > high[k] ? x[k] : high[k];
        }
    }
    Box box = nothing;
    for (int k = 0; k < 12; ++k) {
        const auto part = static_cast<std::size_t>(k / 4);
        box.low[k % 3] = std::min(box.low[k % 3], low[part][k % 4]);
        box.high[k % 3] = std::max(box.high[k % 3], high[part][k % 4]);
    }
    for (; i < points.size(); ++i) {
        box = join(box, {points[i], points[i]});
    }
    return box;
}

Box box_of_any(std::span<const Vec3> points) {
    Box box = nothing;
    for (const Vec3& x : points) {
        box = is_finite(x) ? join(box, {x, x}) : box;
    }
    return box;
}

}  // namespace

Box box_of(std::span<const Vec3> points) {
    constexpr std::size_t grain = 4096;
    const auto around = [&](auto box_of_some) {
        return parallel::reduce(
            static_cast<std::int64_t>((points.size() + grain - 1) / grain), nothing,
            [&](std::int64_t k) {
                const std::size_t first = static_cast<std::size_t>(k) * grain;
                return box_of_some(points.subspan(first, std::min(grain, points.size() - first)));
            },
            join, 1);
    };
    const Box box = around(box_of_finite);
    return is_finite(box.low) && is_finite(box.high) ? box : around(box_of_any);
}

Box box_of(std::span<const Vec3> one, std::span<const Vec3> other) { return join(box_of(one), box_of(other)); }

CellGridView lay_out_cells(const Box& box, std::size_t count, const Domain& domain, double reach, double edge) {
    check_periods(domain, reach);
    CellGridView view{};
    view.reach = reach;
    for (int axis = 0; axis < domain.dimension; ++axis) {  // others have one cell
        CellGridView::Axis& a = view.axes[axis];
        if (domain.is_periodic[static_cast<std::size_t>(axis)]) {
            a.low = domain.low[axis];
            a.period = domain.high[axis] - domain.low[axis];
        } else if (box.low[axis] <= box.high[axis]) {
            a.low = box.low[axis];
        }
    }
    // As many cells as fit, unless that is far more than there are points.
    const double most = 4096 + 4 * static_cast<double>(count);
    for (;; edge *= 2) {
        double cells = 1;
        for (int axis = 0; axis < domain.dimension; ++axis) {
            CellGridView::Axis& a = view.axes[axis];
            const double length = a.period > 0 ? a.period : std::max(0.0, box.high[axis] - a.low);
            const double fitting = std::clamp(std::floor(length / edge), 1.0, 1e9);
            a.cells = static_cast<std::int64_t>(fitting);
            a.per_metre = length > 0 ? fitting / length : 1 / edge;
            cells *= fitting;
        }
        if (cells <= most) {
            return view;
        }
    }
}

void CellGrid::build(std::span<const Vec3> points, const Domain& domain, double reach) {
    cells_ = lay_out_cells(box_of(points), points.size(), domain, reach, reach);
    const auto count = static_cast<std::int64_t>(points.size());
    keys_.resize(points.size());
    points_.resize(points.size());
    start_.resize(static_cast<std::size_t>(cells_.cell_count()) + 1);
    parallel::for_each(count, FindCell{cells_, points.data(), keys_.data(), points_.data()});
    parallel::sort_by_key(keys_, points_, key_buffer_, value_buffer_);
    parallel::for_each(cells_.cell_count() + 1, FindStart{keys_.data(), count, start_.data()});
}

}  // namespace riprap::fluid
