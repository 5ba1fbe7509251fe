// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/bytes.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"

namespace riprap::fluid {

namespace {

/// A box while it grows: low and high relative to a first point, so that boxes across a periodic side stay small.
struct GrowingBox {
    Vec3 base, low, high;
    bool is_empty{true};
    void include(const Vec3& lowest, const Vec3& highest, const NearestImage& nearest);
};

void GrowingBox::include(const Vec3& lowest, const Vec3& highest, const NearestImage& nearest) {
    const Vec3 centre = 0.5 * (lowest + highest);
    const Vec3 half = 0.5 * (highest - lowest);
    if (is_empty) {
        base = centre;
        low = -half;
        high = half;
        is_empty = false;
        return;
    }
    const Vec3 d = nearest(centre - base);
    low = min(low, d - half);
    high = max(high, d + half);
}

}  // namespace

void BoxTree::build(std::span<const Vec3> position, const Domain& domain) {
    const NearestImage nearest(domain);
    const auto n = static_cast<std::int64_t>(position.size());
    std::int64_t count = (n + cluster_size - 1) / cluster_size;
    if (count == 0) {
        levels_.clear();
        return;
    }
    double largest = 0;
    Vec3 periods;
    for (int axis = 0; axis < 3; ++axis) {
        const bool is_periodic = axis < domain.dimension && domain.is_periodic[static_cast<std::size_t>(axis)];
        const double period = is_periodic ? domain.high[axis] - domain.low[axis] : 0;
        period_[static_cast<std::size_t>(axis)] = static_cast<float>(period);
        periods[axis] = period;
    }
    std::vector<GrowingBox> boxes(static_cast<std::size_t>(count));
    parallel::for_each(count, [&](std::int64_t c) {
        GrowingBox& box = boxes[static_cast<std::size_t>(c)];
        for (std::int64_t i = c * cluster_size; i < std::min(n, (c + 1) * cluster_size); ++i) {
            Vec3 x = position[static_cast<std::size_t>(i)] - domain.low;
            for (int axis = 0; axis < 3; ++axis) {
                const double period = periods[axis];
                x[axis] = axis >= domain.dimension ? 0
                          : period > 0             ? x[axis] - period * std::floor(x[axis] / period)
                                                   : x[axis];
            }
            if (is_finite(x)) {
                box.include(x, x, nearest);
            }
        }
    });
    Block nobody;
    nobody.centre.fill(Lanes(0));
    nobody.half.fill(
        Lanes(-std::numeric_limits<float>::infinity()));  // near nothing, also not a box without end (1e30)
    for (std::size_t height = 0;; ++height) {
        const std::int64_t blocks = (count + branches - 1) / branches;
        levels_.resize(std::max(levels_.size(), height + 1));
        std::vector<Block>& level = levels_[height];
        level.resize(static_cast<std::size_t>(blocks));
        const auto fill_block = [&](std::int64_t p) {
            Block& block = level[static_cast<std::size_t>(p)];
            block = nobody;
            double largest_here = 0;
            for (std::int64_t b = p * branches; b < std::min(count, (p + 1) * branches); ++b) {
                const GrowingBox& grown = boxes[static_cast<std::size_t>(b)];
                for (int axis = 0; axis < 3 && !grown.is_empty; ++axis) {
                    const auto k = static_cast<std::size_t>(axis);
                    const double centre = grown.base[axis] + 0.5 * (grown.low[axis] + grown.high[axis]);
                    const double width = grown.high[axis] - grown.low[axis];
                    block.centre[k].set(b % branches, static_cast<float>(centre));
                    block.half[k].set(b % branches, static_cast<float>(0.5 * width));
                    largest_here = std::max({largest_here, std::abs(centre), width});
                }
            }
            return largest_here;
        };
        const auto larger = [](double a, double b) { return std::max(a, b); };
        largest = std::max(largest, parallel::reduce(blocks, 0.0, fill_block, larger, 64));
        if (blocks == 1) {
            levels_.resize(height + 1);
            break;
        }
        std::vector<GrowingBox> parents(static_cast<std::size_t>(blocks));
        parallel::for_each(blocks, [&](std::int64_t p) {
            GrowingBox& parent = parents[static_cast<std::size_t>(p)];
            for (std::int64_t b = p * branches; b < std::min(count, (p + 1) * branches); ++b) {
                const GrowingBox& child = boxes[static_cast<std::size_t>(b)];
                if (!child.is_empty) {
                    parent.include(child.base + child.low, child.base + child.high, nearest);
                }
            }
        });
        boxes = std::move(parents);
        count = blocks;
    }
    slack_ = static_cast<float>(largest * 0x1p-20);
}

BoxTree::Box BoxTree::box(std::size_t level, std::int64_t entry) const {
    const Block& block = levels_[level][static_cast<std::size_t>(entry / branches)];
    Box box{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.centre[axis] = block.centre[axis][entry % branches];
        box.half[axis] = block.half[axis][entry % branches];
    }
    return box;
}

BoxTree::Box BoxTree::box_of_block(std::int64_t block) const {
    if (levels_.size() > 1) {
        return box(1, block);
    }
    return {{}, {1e30F, 1e30F, 1e30F}};  // the only block: everything is near
}

void BoxTree::find_blocks(const Box& box, float distance, std::vector<std::int32_t>& found) const {
    if (levels_.size() > 1) {
        visit(levels_.size() - 1, 0, box, distance, found);
    } else if (!levels_.empty()) {
        found.push_back(0);
    }
}

void BoxTree::visit(std::size_t level, std::int64_t block, const Box& box, float distance,
                    std::vector<std::int32_t>& found) const {
    std::uint32_t hits = near(levels_[level][static_cast<std::size_t>(block)], box, distance);
    for (; hits != 0; hits &= hits - 1) {
        const std::int64_t entry = block * branches + __builtin_ctz(hits);
        if (level == 1) {
            found.push_back(static_cast<std::int32_t>(entry));
        } else {
            visit(level - 1, entry, box, distance, found);
        }
    }
}

std::uint32_t BoxTree::near(const Block& block, const Box& box, float distance) const {
    Lanes square(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Lanes d = block.centre[axis] - Lanes(box.centre[axis]);
        Lanes apart = max(d, -d);
        if (period_[axis] > 0) {
            // centres lie in the period or half a box outside, so less than two periods apart
            for (int turn = 0; turn < 2; ++turn) {
                const Lanes other = apart - Lanes(period_[axis]);
                apart = min(apart, max(other, -other));
            }
        }
        const Lanes gap = max(apart - block.half[axis] - Lanes(box.half[axis]), Lanes(0));
        square += gap * gap;
    }
    return bits_below(square, Lanes(distance * distance));
}

std::size_t BoxTree::bytes() const { return bytes_of(levels_); }

}  // namespace riprap::fluid
