// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/broadphase/single_grid.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::contact {

namespace {

/// Round-off in a cell index, as in CellOrder.
constexpr double cell_margin = 1e-8;

struct Step {
    std::int32_t x, y, z;
};
/// Half of the 26 neighbours: one of every opposite two.
constexpr std::array<Step, 13> half_stencil{{{1, 0, 0},
                                             {-1, 1, 0},
                                             {0, 1, 0},
                                             {1, 1, 0},
                                             {-1, -1, 1},
                                             {0, -1, 1},
                                             {1, -1, 1},
                                             {-1, 0, 1},
                                             {0, 0, 1},
                                             {1, 0, 1},
                                             {-1, 1, 1},
                                             {0, 1, 1},
                                             {1, 1, 1}}};

void keep_if_near(const PartBounds& bounds, std::int32_t a, std::int32_t b, double skin, std::vector<PartPair>& pairs) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    if (spheres_within(bounds.center[i], bounds.radius[i], bounds.center[j], bounds.radius[j], skin) &&
        may_pair(bounds, i, j)) {
        pairs.push_back({std::min(a, b), std::max(a, b)});
    }
}

}  // namespace

void SingleGrid::fill(const PartBounds& bounds, double skin) {
    Vec3 low = bounds.center.front(), high = low;
    double largest = 0;
    for (std::size_t i = 0; i < bounds.center.size(); ++i) {
        low = min(low, bounds.center[i]);
        high = max(high, bounds.center[i]);
        largest = std::max(largest, bounds.radius[i]);
    }
    double cell = (2 * largest + skin) * (1 + cell_margin);
    const Vec3 extent = high - low;
    // At most eight cells a part: a sparse or far-flung scene gets larger cells, not more memory.
    const double cell_limit = 8 * static_cast<double>(bounds.center.size()) + 64;
    const auto cells_along = [&cell](double length) { return std::floor(length / cell) + 1; };
    while (!(cell > 0) || cells_along(extent.x) * cells_along(extent.y) * cells_along(extent.z) > cell_limit) {
        cell = cell > 0 ? 1.2 * cell : 1;
    }
    for (int axis = 0; axis < 3; ++axis) {
        cell_count_[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(cells_along(extent[axis]));
    }
    head_.assign(static_cast<std::size_t>(cell_count_[0]) * static_cast<std::size_t>(cell_count_[1]) *
                     static_cast<std::size_t>(cell_count_[2]),
                 -1);
    next_.resize(bounds.center.size());
    for (std::size_t i = 0; i < bounds.center.size(); ++i) {
        const Vec3 q = (bounds.center[i] - low) / cell;
        const auto x = static_cast<std::size_t>(q.x), y = static_cast<std::size_t>(q.y),
                   z = static_cast<std::size_t>(q.z);
        const std::size_t c =
            (z * static_cast<std::size_t>(cell_count_[1]) + y) * static_cast<std::size_t>(cell_count_[0]) + x;
        next_[i] = head_[c];
        head_[c] = static_cast<std::int32_t>(i);
    }
}

void SingleGrid::find_pairs(const PartBounds& bounds, double skin, std::vector<PartPair>& pairs) {
    pairs.clear();
    if (bounds.size() == 0) {
        return;
    }
    fill(bounds, skin);
    const auto head_at = [this](std::int32_t x, std::int32_t y, std::int32_t z) {
        const bool is_inside =
            x >= 0 && y >= 0 && z >= 0 && x < cell_count_[0] && y < cell_count_[1] && z < cell_count_[2];
        return is_inside ? head_[(static_cast<std::size_t>(z) * static_cast<std::size_t>(cell_count_[1]) +
                                  static_cast<std::size_t>(y)) *
                                     static_cast<std::size_t>(cell_count_[0]) +
                                 static_cast<std::size_t>(x)]
                         : -1;
    };
    const auto after = [this](std::int32_t part) { return next_[static_cast<std::size_t>(part)]; };
    for (std::int32_t z = 0; z < cell_count_[2]; ++z) {
        for (std::int32_t y = 0; y < cell_count_[1]; ++y) {
            for (std::int32_t x = 0; x < cell_count_[0]; ++x) {
                for (std::int32_t a = head_at(x, y, z); a >= 0; a = after(a)) {
                    for (std::int32_t b = after(a); b >= 0; b = after(b)) {
                        keep_if_near(bounds, a, b, skin, pairs);
                    }
                    for (const Step& step : half_stencil) {
                        for (std::int32_t b = head_at(x + step.x, y + step.y, z + step.z); b >= 0; b = after(b)) {
                            keep_if_near(bounds, a, b, skin, pairs);
                        }
                    }
                }
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
}

}  // namespace riprap::contact
