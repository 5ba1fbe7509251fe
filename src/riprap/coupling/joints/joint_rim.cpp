// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_rim.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "riprap/core/index.hpp"

namespace riprap::coupling {

namespace {

/// Returns the axis along which the parts reach farthest.
int longest_axis(std::span<const RimPart> parts) {
    std::array<double, 3> length{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto [least, most] =
            std::ranges::minmax(parts, {}, [axis](const RimPart& part) { return part.place[axis]; });
        length[at(axis)] = most.place[axis] - least.place[axis];
    }
    return static_cast<int>(std::ranges::max_element(length) - length.begin());
}

}  // namespace

std::vector<double> even_rim(std::span<const RimPart> parts, double reach) {
    std::vector<double> around(parts.size(), 0.0);
    if (parts.empty()) {
        return around;
    }
    const int axis = longest_axis(parts);
    std::vector<std::size_t> order(parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return parts[k].place[axis]; });
    double sum = 0, all = 0;
    for (std::size_t first = 0, a = 0; a < order.size(); ++a) {
        const RimPart& own = parts[order[a]];
        while (parts[order[first]].place[axis] < own.place[axis] - reach) {
            ++first;
        }
        double& found = around[order[a]];
        for (std::size_t b = first; b < order.size(); ++b) {
            const RimPart& other = parts[order[b]];
            const Vec3 apart = other.place - own.place;
            if (apart[axis] > reach) {
                break;
            }
            found += other.strength * std::max(0.0, dot(own.inward, other.inward)) *
                     std::max(0.0, 1 - dot(apart, apart) / (reach * reach));
        }
        sum += own.strength * found;
        all += own.strength;
    }
    const double mean = sum / all;
    for (double& found : around) {
        found = mean / std::max(found, mean / 2);
    }
    return around;
}

}  // namespace riprap::coupling
