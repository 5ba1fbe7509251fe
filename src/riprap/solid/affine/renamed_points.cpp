// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/renamed_points.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "riprap/core/index.hpp"

namespace riprap::solid::affine {

namespace {

/// Corners in the name of a point, two of either block; 0 = none. See contact/narrowphase/common_plane_contacts.
std::array<std::uint64_t, 4> corners_of(std::uint64_t feature) {
    constexpr std::uint64_t mask = 0x7FFF;
    return {feature >> 45 & mask, feature >> 30 & mask, feature >> 15 & mask, feature & mask};
}

bool share_a_corner(std::uint64_t one, std::uint64_t other) {
    const auto p = corners_of(one), q = corners_of(other);
    for (std::size_t side = 0; side < 4; side += 2) {
        for (std::size_t i = side; i < side + 2; ++i) {
            if (p[i] != 0 && (p[i] == q[side] || p[i] == q[side + 1])) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace

void carry_renamed(const BlockContactHistory& history, std::size_t begin, std::size_t end,
                   std::span<BlockContact> own) {
    const auto is_new = [](const BlockContact& c) { return c.old < 0; };
    if (end - begin == 0 || std::none_of(own.begin(), own.end(), is_new)) {
        return;
    }
    std::vector<std::uint8_t> is_taken(end - begin, 0);
    for (const BlockContact& c : own) {
        if (c.old >= 0) {
            is_taken[at(c.old) - begin] = 1;
        }
    }
    for (BlockContact& c : own) {
        for (std::size_t row = begin; row < end && c.old < 0; ++row) {
            if (is_taken[row - begin] == 0 && share_a_corner(c.feature, history.feature[row])) {
                c.old = static_cast<std::int64_t>(row);
                is_taken[row - begin] = 1;
            }
        }
    }
}

}  // namespace riprap::solid::affine
