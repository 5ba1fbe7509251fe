// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/core/wide.hpp"
#include "riprap/geometry/polyhedra/convex_view.hpp"

namespace riprap::contact {

/// Eight numbers, one per face of a shape: one register of AVX-512, two of AVX2.
using Lanes = Wide<double, 8>;
/// x, y, z and a number that nobody reads.
using Arm = Wide<double, 4>;
static_assert(sizeof(Lanes) == geometry::shape_lanes * sizeof(double));

/// Zero where |v| <= tolerance.
inline Lanes snap(Lanes v, Lanes tolerance) { return select((v > tolerance) | (v < -tolerance), v, Lanes(0)); }

namespace detail {

template <class Part>
inline double least_in(Part p) {
    using riprap::detail::lesser;
    if constexpr (sizeof(Part) == 8 * sizeof(double)) {
        p = lesser(p, __builtin_shufflevector(p, p, 4, 5, 6, 7, 0, 1, 2, 3));
        p = lesser(p, __builtin_shufflevector(p, p, 2, 3, 0, 1, 6, 7, 4, 5));
    } else if constexpr (sizeof(Part) == 4 * sizeof(double)) {
        p = lesser(p, __builtin_shufflevector(p, p, 2, 3, 0, 1));
    }
    return p[0] < p[1] ? p[0] : p[1];
}

}  // namespace detail

/// The least of the lanes, and the largest.
inline double least(Lanes v) {
    Lanes::Part p = v.part[0];
    for (std::size_t k = 1; k < Lanes::part_count; ++k) {
        p = riprap::detail::lesser(p, v.part[k]);
    }
    return detail::least_in(p);
}
inline double largest(Lanes v) { return -least(-v); }

inline unsigned bits_not_above(Lanes a, Lanes b) { return ~bits_below(b, a) & 0xffU; }

/// Calls `visit(lane)` for every bit set, lowest first.
template <class Visit>
void for_each_bit(unsigned bits, Visit&& visit) {
    for (; bits != 0; bits &= bits - 1) {
        visit(__builtin_ctz(bits));
    }
}

}  // namespace riprap::contact
