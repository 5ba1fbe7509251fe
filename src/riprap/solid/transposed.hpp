// SPDX-License-Identifier: Apache-2.0
#pragma once

// Transpositions in registers between rows of numbers in memory and vectors of the machine: lane k belongs to row k.

#include <cstddef>
#include <cstdint>

#include "riprap/core/wide.hpp"

namespace riprap::solid::transposed {

/// As many numbers as the machine's widest vector holds.
inline constexpr std::int64_t width = vector_bytes / sizeof(double);
using Vector = Wide<double, width>::Part;

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
inline __m512d low(__m512d x, __m512d y) { return _mm512_maskz_unpacklo_pd(0xFF, x, y); }
inline __m512d high(__m512d x, __m512d y) { return _mm512_maskz_unpackhi_pd(0xFF, x, y); }
inline __m512d even(__m512d x, __m512d y) { return _mm512_maskz_shuffle_f64x2(0xFF, x, y, 0x88); }
inline __m512d odd(__m512d x, __m512d y) { return _mm512_maskz_shuffle_f64x2(0xFF, x, y, 0xDD); }
/// Writes every second row of six columns, which come interleaved in pairs; two zeros fill a row.
inline void four_rows(__m512d ab, __m512d cd, __m512d ef, __m512d* rows) {
    const __m512d zero = _mm512_setzero_pd();
    const __m512d abcd04 = even(ab, cd), abcd26 = odd(ab, cd), ef04 = even(ef, zero), ef26 = odd(ef, zero);
    rows[0] = even(abcd04, ef04);
    rows[2] = even(abcd26, ef26);
    rows[4] = odd(abcd04, ef04);
    rows[6] = odd(abcd26, ef26);
}
}  // namespace detail

/// Reads four numbers a row.
inline void load_four(const double* const* row, Vector& a, Vector& b, Vector& c, Vector& d) {
    const __m512d r04 = detail::two_rows(row[0], row[4]), r15 = detail::two_rows(row[1], row[5]),
                  r26 = detail::two_rows(row[2], row[6]), r37 = detail::two_rows(row[3], row[7]);
    const __m512d even01 = detail::low(r04, r15), odd01 = detail::high(r04, r15);
    const __m512d even23 = detail::low(r26, r37), odd23 = detail::high(r26, r37);
    a = detail::low_pairs(even01, even23);
    b = detail::low_pairs(odd01, odd23);
    c = detail::high_pairs(even01, even23);
    d = detail::high_pairs(odd01, odd23);
}

/// Writes four numbers a row.
inline void store_four(Vector a, Vector b, Vector c, Vector d, double* const* row) {
    const __m512d ab_even = detail::low(a, b), ab_odd = detail::high(a, b);
    const __m512d cd_even = detail::low(c, d), cd_odd = detail::high(c, d);
    const auto put = [&](__m512d rows, int k) {
        _mm256_storeu_pd(row[k], _mm512_maskz_extractf64x4_pd(0xF, rows, 0));
        _mm256_storeu_pd(row[k + 4], _mm512_maskz_extractf64x4_pd(0xF, rows, 1));
    };
    put(detail::low_pairs(ab_even, cd_even), 0);
    put(detail::low_pairs(ab_odd, cd_odd), 1);
    put(detail::high_pairs(ab_even, cd_even), 2);
    put(detail::high_pairs(ab_odd, cd_odd), 3);
}

/// Six numbers a row and two zeros.
struct SixRows {
    __m512d row[width];
    explicit SixRows(const Vector (&column)[6]) {
        detail::four_rows(detail::low(column[0], column[1]), detail::low(column[2], column[3]),
                          detail::low(column[4], column[5]), row);
        detail::four_rows(detail::high(column[0], column[1]), detail::high(column[2], column[3]),
                          detail::high(column[4], column[5]), row + 1);
    }
    /// Adds row k to the six numbers at `to`; two more follow them, and they begin at a multiple of 64 bytes.
    void add(std::int64_t k, double* to) const {
        _mm512_store_pd(to, _mm512_maskz_add_pd(0xFF, _mm512_load_pd(to), row[k]));
    }
};

/// Reads rows of three numbers that follow each other.
inline void load_three(const double* from, Vector& x, Vector& y, Vector& z) {
    const __m512d a = _mm512_loadu_pd(from), b = _mm512_loadu_pd(from + 8), c = _mm512_loadu_pd(from + 16);
    const auto pick = [&](__m512i of_ab, __m512i with_c) {
        return _mm512_maskz_permutex2var_pd(0xFF, _mm512_maskz_permutex2var_pd(0xFF, a, of_ab, b), with_c, c);
    };
    x = pick(_mm512_set_epi64(0, 0, 15, 12, 9, 6, 3, 0), _mm512_set_epi64(13, 10, 5, 4, 3, 2, 1, 0));
    y = pick(_mm512_set_epi64(0, 0, 0, 13, 10, 7, 4, 1), _mm512_set_epi64(14, 11, 8, 4, 3, 2, 1, 0));
    z = pick(_mm512_set_epi64(0, 0, 0, 14, 11, 8, 5, 2), _mm512_set_epi64(15, 12, 9, 4, 3, 2, 1, 0));
}

/// Writes rows of three numbers that follow each other.
inline void store_three(Vector x, Vector y, Vector z, double* to) {
    const auto put = [&](double* place, __m512i of_xy, __m512i with_z) {
        const __m512d xy = _mm512_maskz_permutex2var_pd(0xFF, x, of_xy, y);
        _mm512_storeu_pd(place, _mm512_maskz_permutex2var_pd(0xFF, xy, with_z, z));
    };
    put(to, _mm512_set_epi64(10, 2, 0, 9, 1, 0, 8, 0), _mm512_set_epi64(7, 6, 9, 4, 3, 8, 1, 0));
    put(to + 8, _mm512_set_epi64(5, 0, 12, 4, 0, 11, 3, 0), _mm512_set_epi64(7, 12, 5, 4, 11, 2, 1, 10));
    put(to + 16, _mm512_set_epi64(0, 15, 7, 0, 14, 6, 0, 13), _mm512_set_epi64(15, 6, 5, 14, 3, 2, 13, 0));
}

#elif defined(__AVX2__)

inline void load_four(const double* const* row, Vector& a, Vector& b, Vector& c, Vector& d) {
    const __m256d r0 = _mm256_loadu_pd(row[0]), r1 = _mm256_loadu_pd(row[1]), r2 = _mm256_loadu_pd(row[2]),
                  r3 = _mm256_loadu_pd(row[3]);
    const __m256d even01 = _mm256_unpacklo_pd(r0, r1), odd01 = _mm256_unpackhi_pd(r0, r1);
    const __m256d even23 = _mm256_unpacklo_pd(r2, r3), odd23 = _mm256_unpackhi_pd(r2, r3);
    a = _mm256_permute2f128_pd(even01, even23, 0x20);
    b = _mm256_permute2f128_pd(odd01, odd23, 0x20);
    c = _mm256_permute2f128_pd(even01, even23, 0x31);
    d = _mm256_permute2f128_pd(odd01, odd23, 0x31);
}

inline void store_four(Vector a, Vector b, Vector c, Vector d, double* const* row) {
    const __m256d ab02 = _mm256_unpacklo_pd(a, b), ab13 = _mm256_unpackhi_pd(a, b);
    const __m256d cd02 = _mm256_unpacklo_pd(c, d), cd13 = _mm256_unpackhi_pd(c, d);
    _mm256_storeu_pd(row[0], _mm256_permute2f128_pd(ab02, cd02, 0x20));
    _mm256_storeu_pd(row[1], _mm256_permute2f128_pd(ab13, cd13, 0x20));
    _mm256_storeu_pd(row[2], _mm256_permute2f128_pd(ab02, cd02, 0x31));
    _mm256_storeu_pd(row[3], _mm256_permute2f128_pd(ab13, cd13, 0x31));
}

struct SixRows {
    __m256d front[width];
    __m128d back[width];
    explicit SixRows(const Vector (&column)[6]) {
        const __m256d ab02 = _mm256_unpacklo_pd(column[0], column[1]), ab13 = _mm256_unpackhi_pd(column[0], column[1]);
        const __m256d cd02 = _mm256_unpacklo_pd(column[2], column[3]), cd13 = _mm256_unpackhi_pd(column[2], column[3]);
        const __m256d ef02 = _mm256_unpacklo_pd(column[4], column[5]), ef13 = _mm256_unpackhi_pd(column[4], column[5]);
        front[0] = _mm256_permute2f128_pd(ab02, cd02, 0x20);
        front[1] = _mm256_permute2f128_pd(ab13, cd13, 0x20);
        front[2] = _mm256_permute2f128_pd(ab02, cd02, 0x31);
        front[3] = _mm256_permute2f128_pd(ab13, cd13, 0x31);
        back[0] = _mm256_castpd256_pd128(ef02);
        back[1] = _mm256_castpd256_pd128(ef13);
        back[2] = _mm256_extractf128_pd(ef02, 1);
        back[3] = _mm256_extractf128_pd(ef13, 1);
    }
    void add(std::int64_t k, double* to) const {
        _mm256_store_pd(to, _mm256_add_pd(_mm256_load_pd(to), front[k]));
        _mm_store_pd(to + 4, _mm_add_pd(_mm_load_pd(to + 4), back[k]));
    }
};

inline void load_three(const double* from, Vector& x, Vector& y, Vector& z) {
    const __m256d a = _mm256_loadu_pd(from), b = _mm256_loadu_pd(from + 4), c = _mm256_loadu_pd(from + 8);
    const __m256d xy02 = _mm256_blend_pd(a, b, 0xC), zx = _mm256_permute2f128_pd(a, c, 0x21),
                  yz13 = _mm256_blend_pd(b, c, 0xC);
    x = _mm256_blend_pd(xy02, zx, 0xA);
    y = _mm256_shuffle_pd(xy02, yz13, 0x5);
    z = _mm256_blend_pd(zx, yz13, 0xA);
}

inline void store_three(Vector x, Vector y, Vector z, double* to) {
    const __m256d xy02 = _mm256_unpacklo_pd(x, y), zx = _mm256_blend_pd(z, x, 0xA), yz13 = _mm256_unpackhi_pd(y, z);
    _mm256_storeu_pd(to, _mm256_permute2f128_pd(xy02, zx, 0x20));
    _mm256_storeu_pd(to + 4, _mm256_blend_pd(yz13, xy02, 0xC));
    _mm256_storeu_pd(to + 8, _mm256_permute2f128_pd(zx, yz13, 0x31));
}

#else

inline void load_four(const double* const* row, Vector& a, Vector& b, Vector& c, Vector& d) {
    for (std::int64_t k = 0; k < width; ++k) {
        a[k] = row[k][0];
        b[k] = row[k][1];
        c[k] = row[k][2];
        d[k] = row[k][3];
    }
}

inline void store_four(Vector a, Vector b, Vector c, Vector d, double* const* row) {
    for (std::int64_t k = 0; k < width; ++k) {
        row[k][0] = a[k];
        row[k][1] = b[k];
        row[k][2] = c[k];
        row[k][3] = d[k];
    }
}

struct SixRows {
    Vector column[6];
    explicit SixRows(const Vector (&columns)[6]) {
        for (std::size_t n = 0; n < 6; ++n) {
            column[n] = columns[n];
        }
    }
    void add(std::int64_t k, double* to) const {
        for (std::size_t n = 0; n < 6; ++n) {
            to[n] += column[n][k];
        }
    }
};

inline void load_three(const double* from, Vector& x, Vector& y, Vector& z) {
    for (std::int64_t k = 0; k < width; ++k, from += 3) {
        x[k] = from[0];
        y[k] = from[1];
        z[k] = from[2];
    }
}

inline void store_three(Vector x, Vector y, Vector z, double* to) {
    for (std::int64_t k = 0; k < width; ++k, to += 3) {
        to[0] = x[k];
        to[1] = y[k];
        to[2] = z[k];
    }
}

#endif

}  // namespace riprap::solid::transposed
