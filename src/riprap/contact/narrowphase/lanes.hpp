// SPDX-License-Identifier: Apache-2.0
#pragma once

#if defined(__AVX512F__)
#include <immintrin.h>
#endif

#include <cstdint>

#include "riprap/geometry/convex_view.hpp"

namespace riprap::contact {

/// Eight numbers, one per face of a shape (vector extension of GCC and Clang; one AVX-512 register).
using Lanes = double __attribute__((vector_size(8 * sizeof(double))));
static_assert(sizeof(Lanes) == geometry::shape_lanes * sizeof(double));

inline Lanes load(const double* p) {
    Lanes v;
    __builtin_memcpy(&v, p, sizeof v);
    return v;
}
inline Lanes broadcast(double s) { return Lanes{s, s, s, s, s, s, s, s}; }
inline Lanes min(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes max(Lanes a, Lanes b) { return a > b ? a : b; }
/// Zero where |v| <= tolerance.
inline Lanes snap(Lanes v, Lanes tolerance) {
    const Lanes zero = broadcast(0);
    return v > tolerance ? v : v < -tolerance ? v : zero;
}

/// The least of the lanes.
inline double least(Lanes v) {
    v = min(v, __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3));
    v = min(v, __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5));
    return v[0] < v[1] ? v[0] : v[1];
}

/// One bit per lane.
inline unsigned bits_below(Lanes a, Lanes b) {
#if defined(__AVX512F__)
    return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
#else
    unsigned bits = 0;
    for (int i = 0; i < 8; ++i) {
        bits |= (a[i] < b[i] ? 1U : 0U) << i;
    }
    return bits;
#endif
}
inline unsigned bits_not_above(Lanes a, Lanes b) { return ~bits_below(b, a) & 0xffU; }

/// Calls `visit(lane)` for every bit set, lowest first.
template <class Visit>
void for_each_bit(unsigned bits, Visit&& visit) {
    for (; bits != 0; bits &= bits - 1) {
        visit(__builtin_ctz(bits));
    }
}

}  // namespace riprap::contact
