// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "riprap/core/vec3.hpp"
#include "riprap/core/wide.hpp"

namespace riprap::coupling {

// Samples in fours that follow each other: loops over pairs of them look at four at a time.

using Four = Wide<double, 4>;
using FourMask = WideMask<double, 4>;
inline constexpr std::size_t four_size = 4;

/// Four vectors.
struct Four3 {
    Four x, y, z;

    Four3() : x(0), y(0), z(0) {}
    explicit Four3(const Vec3& a) : x(a.x), y(a.y), z(a.z) {}
    Four3(Four first, Four second, Four third) : x(first), y(second), z(third) {}
    Vec3 lane(std::size_t k) const {
        const auto l = static_cast<std::int64_t>(k);
        return {x[l], y[l], z[l]};
    }
    void set(std::size_t k, const Vec3& a) {
        const auto l = static_cast<std::int64_t>(k);
        x.set(l, a.x);
        y.set(l, a.y);
        z.set(l, a.z);
    }
};
inline Four3 operator+(const Four3& a, const Four3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Four3 operator-(const Four3& a, const Four3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Four3 operator*(Four s, const Four3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Four dot(const Four3& a, const Four3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Sums and least of the lanes, in a fixed order.
inline double sum_of(Four a) { return (a[0] + a[1]) + (a[2] + a[3]); }
inline Vec3 sum_of(const Four3& a) { return {sum_of(a.x), sum_of(a.y), sum_of(a.z)}; }

inline FourMask mask_of(std::uint32_t bits) {
    FourMask mask;
    for (std::int64_t lane = 0; lane < 4; ++lane) {
        mask.set(lane, -static_cast<std::int64_t>((bits >> lane) & 1U));
    }
    return mask;
}
inline std::uint32_t bits_of(FourMask mask) { return bits_below(select(mask, Four(-1), Four(0)), Four(0)); }

/// Four samples as joints see them.
struct SampleFour {
    Four3 place, normal;  ///< world [m], [-]
    Four volume{0.0}, depth{0.0};
    std::array<std::int32_t, four_size> member{-1, -1, -1, -1};   ///< numbers in JointPairs::members; -1: none
    std::array<std::int32_t, four_size> partner{-1, -1, -1, -1};  ///< of partner_of

    bool is_of_one_partner() const {
        return partner[0] == partner[1] && partner[0] == partner[2] && partner[0] == partner[3];
    }
};

}  // namespace riprap::coupling
