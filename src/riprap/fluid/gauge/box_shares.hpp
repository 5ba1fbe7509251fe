// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <unordered_set>

#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// Shares in a box of the water that particles stand for. A particle at x takes the cell of one spacing l about it, so
/// that along an axis the box [a, b] holds
///
///     1 - max(0, a - x + l/2)/l - max(0, x + l/2 - b)/l
///
/// of it: exact where water goes on beyond the sides, as on a lattice, where a count of centres is off by up to half a
/// layer. Beside a side with no particle within 1.5 l beyond it the water ends there, at a wall say, and particles next
/// to it count whole, also where they are pressed closer to the wall than half a spacing.
class BoxShares {
 public:
    /// @param spacing  l [m]
    /// @param axes     2 or 3
    BoxShares(const Vec3& low, const Vec3& high, double spacing, int axes)
        : low_(low), high_(high), spacing_(spacing), axes_(axes) {}

    /// Tells whether a particle at x has a share, or says of one in the box that water goes on beyond a side.
    bool is_near(const Vec3& x) const;
    /// Notes the places beyond sides at which there is water; of all particles that are near, before share().
    void note(const Vec3& x);
    /// Share of the particle at x that the box holds [-].
    double share(const Vec3& x) const;

 private:
    struct Place {
        std::array<std::int64_t, 3> cell;
        bool operator==(const Place&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Place& place) const;
    };
    Place place_beside(const Vec3& x, int axis) const;
    bool goes_on(const Vec3& x, int axis, int side) const;

    Vec3 low_, high_;
    double spacing_;
    int axes_;
    std::array<std::array<std::unordered_set<Place, Hash>, 2>, 3> beyond_;  ///< per axis and side, in cells of l
};

}  // namespace riprap::fluid
