// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/core/vec3.hpp"
#include "riprap/core/wide.hpp"

namespace riprap::solid {

/// Contacts or bodies that are computed side by side.
inline constexpr std::int64_t lanes = 8;
using Eight = Wide<double, 8>;
using Vec3x8 = Vec3T<Eight>;

/// Eight rows of a table.
struct RowIndex {
    alignas(32) std::int32_t row[8];
};

/// Numbers base[row * Stride] of eight rows.
template <int Stride>
inline Eight gather(const double* base, const RowIndex& index) {
#if defined(__AVX512F__)
    const __m256i rows = _mm256_load_si256(reinterpret_cast<const __m256i*>(index.row));
    const __m256i places = _mm256_mullo_epi32(rows, _mm256_set1_epi32(Stride));
    Eight out;
    out.part[0] = _mm512_mask_i32gather_pd(_mm512_setzero_pd(), 0xFF, places, base, 8);
    return out;
#else
    Eight out{};
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        out.set(lane, base[static_cast<std::int64_t>(index.row[lane]) * Stride]);
    }
    return out;
#endif
}

/// Four numbers of eight rows.
struct FourByEight {
    Eight a, b, c, d;
};

#if defined(__AVX512F__)
namespace detail {
inline __m512d two_rows(const double* low, const double* high) {
    const __m512d wide = _mm512_maskz_broadcast_f64x4(0xFF, _mm256_loadu_pd(low));
    return _mm512_maskz_insertf64x4(0xFF, wide, _mm256_loadu_pd(high), 1);
}
inline __m512d low_pairs(__m512d x, __m512d y) {
    return _mm512_maskz_permutex2var_pd(0xFF, x, _mm512_set_epi64(13, 12, 5, 4, 9, 8, 1, 0), y);
}
inline __m512d high_pairs(__m512d x, __m512d y) {
    return _mm512_maskz_permutex2var_pd(0xFF, x, _mm512_set_epi64(15, 14, 7, 6, 11, 10, 3, 2), y);
}
}  // namespace detail
#endif

/// Four numbers at each of eight places: a transposition in registers.
inline FourByEight load_four(const double* const (&at)[8]) {
    FourByEight out;
#if defined(__AVX512F__)
    const __m512d r04 = detail::two_rows(at[0], at[4]), r15 = detail::two_rows(at[1], at[5]),
                  r26 = detail::two_rows(at[2], at[6]), r37 = detail::two_rows(at[3], at[7]);
    const __m512d even01 = _mm512_maskz_unpacklo_pd(0xFF, r04, r15), odd01 = _mm512_maskz_unpackhi_pd(0xFF, r04, r15);
    const __m512d even23 = _mm512_maskz_unpacklo_pd(0xFF, r26, r37), odd23 = _mm512_maskz_unpackhi_pd(0xFF, r26, r37);
    out.a.part[0] = detail::low_pairs(even01, even23);
    out.b.part[0] = detail::low_pairs(odd01, odd23);
    out.c.part[0] = detail::high_pairs(even01, even23);
    out.d.part[0] = detail::high_pairs(odd01, odd23);
#else
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        out.a.set(lane, at[lane][0]);
        out.b.set(lane, at[lane][1]);
        out.c.set(lane, at[lane][2]);
        out.d.set(lane, at[lane][3]);
    }
#endif
    return out;
}
/// Numbers base[row * Stride] to base[row * Stride + 3] of eight rows.
template <int Stride>
inline FourByEight load_four(const double* base, const RowIndex& index) {
    const double* at[8];
    for (int k = 0; k < 8; ++k) {
        at[k] = base + static_cast<std::int64_t>(index.row[k]) * Stride;
    }
    return load_four(at);
}

/// Writes four numbers a row at to[k], k < count.
inline void store_four(const FourByEight& from, double* const* to, std::int64_t count) {
    alignas(64) double rows[32];
#if defined(__AVX512F__)
    const __m512d ab_even = _mm512_maskz_unpacklo_pd(0xFF, from.a.part[0], from.b.part[0]),
                  ab_odd = _mm512_maskz_unpackhi_pd(0xFF, from.a.part[0], from.b.part[0]);
    const __m512d cd_even = _mm512_maskz_unpacklo_pd(0xFF, from.c.part[0], from.d.part[0]),
                  cd_odd = _mm512_maskz_unpackhi_pd(0xFF, from.c.part[0], from.d.part[0]);
    _mm512_store_pd(rows, detail::low_pairs(ab_even, cd_even));        // rows 0 and 4
    _mm512_store_pd(rows + 8, detail::low_pairs(ab_odd, cd_odd));      // rows 1 and 5
    _mm512_store_pd(rows + 16, detail::high_pairs(ab_even, cd_even));  // rows 2 and 6
    _mm512_store_pd(rows + 24, detail::high_pairs(ab_odd, cd_odd));    // rows 3 and 7
    for (std::int64_t k = 0; k < count; ++k) {
        __builtin_memcpy(to[k], rows + 8 * (k & 3) + 4 * (k >> 2), 32);
    }
#else
    for (std::int64_t k = 0; k < count; ++k) {
        const double row[4] = {from.a[k], from.b[k], from.c[k], from.d[k]};
        __builtin_memcpy(to[k], row, 32);
    }
    static_cast<void>(rows);
#endif
}

/// Adds six numbers a row to those at to[k], k < count, one row after the other; rows have eight numbers and begin at
/// multiples of 64 bytes.
inline void add_six(const Vec3x8& front, const Vec3x8& back, double* const* to, std::int64_t count) {
#if defined(__AVX512F__)
    const auto low = [](__m512d x, __m512d y) { return _mm512_maskz_unpacklo_pd(0xFF, x, y); };
    const auto high = [](__m512d x, __m512d y) { return _mm512_maskz_unpackhi_pd(0xFF, x, y); };
    const auto even = [](__m512d x, __m512d y) { return _mm512_maskz_shuffle_f64x2(0xFF, x, y, 0x88); };
    const auto odd = [](__m512d x, __m512d y) { return _mm512_maskz_shuffle_f64x2(0xFF, x, y, 0xDD); };
    const __m512d zero = _mm512_setzero_pd();
    __m512d rows[lanes];
    const auto four_rows = [&](__m512d ab, __m512d cd, __m512d ef, int first) {
        const __m512d abcd04 = even(ab, cd), abcd26 = odd(ab, cd), ef04 = even(ef, zero), ef26 = odd(ef, zero);
        rows[first] = even(abcd04, ef04);
        rows[first + 2] = even(abcd26, ef26);
        rows[first + 4] = odd(abcd04, ef04);
        rows[first + 6] = odd(abcd26, ef26);
    };
    const __m512d a = front.x.part[0], b = front.y.part[0], c = front.z.part[0], d = back.x.part[0], e = back.y.part[0],
                  f = back.z.part[0];
    four_rows(low(a, b), low(c, d), low(e, f), 0);
    four_rows(high(a, b), high(c, d), high(e, f), 1);
    const auto add = [&](std::int64_t k) {
        _mm512_store_pd(to[k], _mm512_maskz_add_pd(0xFF, _mm512_load_pd(to[k]), rows[k]));
    };
    if (count == lanes) {
        for (std::int64_t k = 0; k < lanes; ++k) {
            add(k);
        }
    } else {
        for (std::int64_t k = 0; k < count; ++k) {
            add(k);
        }
    }
#else
    for (std::int64_t k = 0; k < count; ++k) {
        const double row[6] = {front.x[k], front.y[k], front.z[k], back.x[k], back.y[k], back.z[k]};
        for (int n = 0; n < 6; ++n) {
            to[k][n] += row[n];
        }
    }
#endif
}

/// Eight vectors in a row, from memory to lanes and back: transpositions in registers.
inline Vec3x8 load_vectors(const Vec3* from) {
#if defined(__AVX512F__)
    const double* p = &from->x;
    const __m512d a = _mm512_loadu_pd(p), b = _mm512_loadu_pd(p + 8), c = _mm512_loadu_pd(p + 16);
    const auto pick = [&](__m512i of_ab, __m512i with_c) {
        return _mm512_maskz_permutex2var_pd(0xFF, _mm512_maskz_permutex2var_pd(0xFF, a, of_ab, b), with_c, c);
    };
    Vec3x8 v;
    v.x.part[0] = pick(_mm512_set_epi64(0, 0, 15, 12, 9, 6, 3, 0), _mm512_set_epi64(13, 10, 5, 4, 3, 2, 1, 0));
    v.y.part[0] = pick(_mm512_set_epi64(0, 0, 0, 13, 10, 7, 4, 1), _mm512_set_epi64(14, 11, 8, 4, 3, 2, 1, 0));
    v.z.part[0] = pick(_mm512_set_epi64(0, 0, 0, 14, 11, 8, 5, 2), _mm512_set_epi64(15, 12, 9, 4, 3, 2, 1, 0));
    return v;
#else
    Vec3x8 v;
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        v.x.set(lane, from[lane].x);
        v.y.set(lane, from[lane].y);
        v.z.set(lane, from[lane].z);
    }
    return v;
#endif
}
inline void store_vectors(const Vec3x8& v, Vec3* to) {
#if defined(__AVX512F__)
    double* p = &to->x;
    const auto put = [&](double* place, __m512i of_xy, __m512i with_z) {
        const __m512d xy = _mm512_maskz_permutex2var_pd(0xFF, v.x.part[0], of_xy, v.y.part[0]);
        _mm512_storeu_pd(place, _mm512_maskz_permutex2var_pd(0xFF, xy, with_z, v.z.part[0]));
    };
    put(p, _mm512_set_epi64(10, 2, 0, 9, 1, 0, 8, 0), _mm512_set_epi64(7, 6, 9, 4, 3, 8, 1, 0));
    put(p + 8, _mm512_set_epi64(5, 0, 12, 4, 0, 11, 3, 0), _mm512_set_epi64(7, 12, 5, 4, 11, 2, 1, 10));
    put(p + 16, _mm512_set_epi64(0, 15, 7, 0, 14, 6, 0, 13), _mm512_set_epi64(15, 6, 5, 14, 3, 2, 13, 0));
#else
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        to[lane] = {v.x[lane], v.y[lane], v.z[lane]};
    }
#endif
}

/// Vectors of eight rows of an array of Vec3.
inline Vec3x8 gather(const Vec3* base, const RowIndex& index) {
    return {gather<3>(&base->x, index), gather<3>(&base->y, index), gather<3>(&base->z, index)};
}

/// Vector of one lane.
inline Vec3 lane_of(const Vec3x8& v, std::int64_t lane) { return {v.x[lane], v.y[lane], v.z[lane]}; }

}  // namespace riprap::solid
