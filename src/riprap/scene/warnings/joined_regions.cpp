// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/warnings/joined_regions.hpp"

#include <algorithm>
#include <limits>

#include "riprap/core/index.hpp"

namespace riprap::scene {

namespace {

/// The box around the places of a region.
struct Box {
    Vec3 low{1, 1, 1}, high{};
    bool is_empty{true};
};

std::vector<Box> boxes_of(const coupling::Filling& filling) {
    std::vector<Box> boxes(filling.regions.size());
    for (std::size_t i = 0; i < filling.particles.position.size(); ++i) {
        Box& box = boxes[at(filling.region[i])];
        const Vec3& x = filling.particles.position[i];
        box = {box.is_empty ? x : min(box.low, x), box.is_empty ? x : max(box.high, x), false};
    }
    return boxes;
}

/// Are there places of both within `reach` along every axis?
bool do_meet(const Box& a, const Box& b, double reach) {
    bool meet = !a.is_empty && !b.is_empty;
    for (int axis = 0; axis < 3; ++axis) {
        meet = meet && a.low[axis] <= b.high[axis] + reach && b.low[axis] <= a.high[axis] + reach;
    }
    return meet;
}

}  // namespace

std::vector<double> joined_depths(const coupling::Filling& filling, std::vector<double> depths, double spacing) {
    constexpr double reach = 1.5;  // spacings: places of one lattice that stand side by side
    const std::vector<Box> boxes = boxes_of(filling);
    const std::size_t count = std::min(boxes.size(), depths.size());
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (std::size_t a = 0; a < count; ++a) {
            for (std::size_t b = 0; b < count; ++b) {
                if (depths[b] > depths[a] && do_meet(boxes[a], boxes[b], reach * spacing)) {
                    depths[a] = depths[b];
                    has_changed = true;
                }
            }
        }
    }
    return depths;
}

}  // namespace riprap::scene
