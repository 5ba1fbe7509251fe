// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace riprap::fluid {

/// Places as whole numbers of a small length, modulo 2^32. Differences of such places are exact wherever in the domain
/// they are taken, and exactly opposite for the two directions of a pair, and along a periodic axis, whose period is
/// 2^32 of these lengths, they lead to the nearest image by themselves. A place is rounded once, by at most half the
/// small length: 2 h/2^25 in domains up to 64 h long, less than 1e-6 spacings up to some thousand spacings.
class FixedPoint {
 public:
    FixedPoint() = default;
    /// @param extent  of all particles along each axis [m]
    FixedPoint(const SweepReach& reach, const Vec3& extent) : origin_(reach.domain.low) {
        for (int axis = 0; axis < 3; ++axis) {
            if (reach.domain.is_periodic[static_cast<std::size_t>(axis)]) {
                quantum_[axis] = std::ldexp(reach.domain.high[axis] - reach.domain.low[axis], -32);
            } else {
                // Powers of two times the reach, so that the same length serves while the extent changes little. Far
                // ends of the particles must not meet modulo 2^32: two reaches between them.
                const double reaches = std::clamp(extent[axis] / reach.support_radius + 2, 32.0, 1e9);
                quantum_[axis] = std::ldexp(reach.support_radius, std::ilogb(reaches) + 1 - 32);
            }
            per_quantum_[axis] = axis < reach.domain.dimension ? 1 / quantum_[axis] : 0;
        }
    }

    /// x along the axis in small lengths, rounded, modulo 2^32; anywhere for places beyond 2^51 of them.
    RIPRAP_HD std::int32_t operator()(const Vec3& x, int axis) const {
        const double rounded = (x[axis] - origin_[axis]) * per_quantum_[axis] + 0x1.8p52;
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(rounded)));
    }
    const Vec3& origin() const { return origin_; }
    const Vec3& per_quantum() const { return per_quantum_; }
    /// [m]
    const Vec3& quantum() const { return quantum_; }

    friend bool operator==(const FixedPoint&, const FixedPoint&) = default;

 private:
    Vec3 origin_{}, quantum_{}, per_quantum_{};
};

}  // namespace riprap::fluid
