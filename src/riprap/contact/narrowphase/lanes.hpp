// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/core/wide.hpp"
#include "riprap/geometry/convex_view.hpp"

namespace riprap::contact {

/// Eight numbers, one per face of a shape: one register of AVX-512, two of AVX2.
using Lanes = Wide<double, 8>;
/// x, y, z and a number that nobody reads.
using Arm = Wide<double, 4>;
static_assert(sizeof(Lanes) == geometry::shape_lanes * sizeof(double));

/// Zero where |v| <= tolerance.
inline Lanes snap(Lanes v, Lanes tolerance) { return select((v > tolerance) | (v < -tolerance), v, Lanes(0)); }

/// The largest of the lanes.
inline double largest(Lanes v) {
    const auto better = [](double a, double b) { return a > b ? a : b; };
    return better(better(better(v[0], v[4]), better(v[2], v[6])), better(better(v[1], v[5]), better(v[3], v[7])));
}
/// The least of the lanes.
inline double least(Lanes v) { return -largest(-v); }

inline unsigned bits_not_above(Lanes a, Lanes b) { return ~bits_below(b, a) & 0xffU; }

/// Calls `visit(lane)` for every bit set, lowest first.
template <class Visit>
void for_each_bit(unsigned bits, Visit&& visit) {
    for (; bits != 0; bits &= bits - 1) {
        visit(__builtin_ctz(bits));
    }
}

}  // namespace riprap::contact
