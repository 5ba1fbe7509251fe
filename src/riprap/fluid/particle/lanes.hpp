// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sixteen floats side by side, with the arithmetic that pair physics needs. Written with the vector extension of GCC
// and clang, which cuts the sixteen to what the machine has; where the machine's own estimates of reciprocals are used,
// one step of Newton's follows. Lane l stands for target l/4 and candidate l%4 of two clusters of four.

#include <cstdint>
#include <type_traits>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace riprap::fluid {

inline constexpr int cluster_size = 4;
inline constexpr int lane_count = cluster_size * cluster_size;

using FloatVector [[gnu::vector_size(lane_count * sizeof(float))]] = float;
using IntVector [[gnu::vector_size(lane_count * sizeof(std::int32_t))]] = std::int32_t;
using FloatFour [[gnu::vector_size(cluster_size * sizeof(float))]] = float;
using IntFour [[gnu::vector_size(cluster_size * sizeof(std::int32_t))]] = std::int32_t;

using DoubleFour [[gnu::vector_size(cluster_size * sizeof(double))]] = double;

using FloatEight [[gnu::vector_size(2 * cluster_size * sizeof(float))]] = float;

/// One truth per lane.
struct LaneMask {
    IntVector v;
};

struct Lanes {
    FloatVector v;

    Lanes() = default;
    Lanes(FloatVector vector) : v(vector) {}
    /// The same number in all lanes.
    template <class Number>
    requires std::is_arithmetic_v<Number>
    explicit Lanes(Number a) : v(static_cast<float>(a) - FloatVector{}) {}

    Lanes& operator+=(Lanes b) { return *this = Lanes(v + b.v); }
    Lanes& operator-=(Lanes b) { return *this = Lanes(v - b.v); }
    Lanes& operator*=(Lanes b) { return *this = Lanes(v * b.v); }
};

inline Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
inline Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
inline Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
inline Lanes operator-(Lanes a) { return -a.v; }
inline LaneMask operator<(Lanes a, Lanes b) { return {a.v < b.v}; }
inline LaneMask operator>(Lanes a, Lanes b) { return {a.v > b.v}; }
inline LaneMask operator<=(Lanes a, Lanes b) { return {a.v <= b.v}; }
inline LaneMask operator>=(Lanes a, Lanes b) { return {a.v >= b.v}; }
inline LaneMask operator&(LaneMask a, LaneMask b) { return {a.v & b.v}; }
inline LaneMask operator|(LaneMask a, LaneMask b) { return {a.v | b.v}; }

inline Lanes select(LaneMask condition, Lanes a, Lanes b) { return condition.v ? a.v : b.v; }

namespace detail {
#if defined(__AVX512F__)
/// The masked forms with all lanes on: the same instructions, without GCC 12's warning of an uninitialised register.
inline constexpr unsigned short all_lanes = 0xFFFF;
#endif
/// 1/a to at least 11 bits
inline FloatVector estimate_reciprocal(FloatVector a) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatVector>(_mm512_maskz_rcp14_ps(detail::all_lanes, reinterpret_cast<__m512>(a)));
#elif defined(__AVX2__)
    struct Halves {
        __m256 low, high;
    } h;
    __builtin_memcpy(&h, &a, sizeof a);
    h = {_mm256_rcp_ps(h.low), _mm256_rcp_ps(h.high)};
    __builtin_memcpy(&a, &h, sizeof a);
    return a;
#else
    return 1.0F / a;
#endif
}
/// 1/sqrt(a) to at least 11 bits
inline FloatVector estimate_reciprocal_sqrt(FloatVector a) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatVector>(_mm512_maskz_rsqrt14_ps(detail::all_lanes, reinterpret_cast<__m512>(a)));
#elif defined(__AVX2__)
    struct Halves {
        __m256 low, high;
    } h;
    __builtin_memcpy(&h, &a, sizeof a);
    h = {_mm256_rsqrt_ps(h.low), _mm256_rsqrt_ps(h.high)};
    __builtin_memcpy(&a, &h, sizeof a);
    return a;
#else
    for (int lane = 0; lane < lane_count; ++lane) {
        a[lane] = 1.0F / __builtin_sqrtf(a[lane]);
    }
    return a;
#endif
}
}  // namespace detail

inline Lanes min(Lanes a, Lanes b) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatVector>(
        _mm512_maskz_min_ps(detail::all_lanes, reinterpret_cast<__m512>(a.v), reinterpret_cast<__m512>(b.v)));
#else
    return a.v < b.v ? a.v : b.v;
#endif
}
inline Lanes max(Lanes a, Lanes b) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatVector>(
        _mm512_maskz_max_ps(detail::all_lanes, reinterpret_cast<__m512>(a.v), reinterpret_cast<__m512>(b.v)));
#else
    return a.v > b.v ? a.v : b.v;
#endif
}
inline Lanes reciprocal(Lanes a) {
    const FloatVector y = detail::estimate_reciprocal(a.v);
    return y + y * (1.0F - a.v * y);
}
inline Lanes reciprocal_sqrt(Lanes a) {
    const FloatVector y = detail::estimate_reciprocal_sqrt(a.v);
    return y + y * (0.5F - 0.5F * a.v * y * y);
}
/// sqrt(a) for a > 0.
inline Lanes distance(Lanes a) {
    const FloatVector y = detail::estimate_reciprocal_sqrt(a.v);
    const FloatVector root = a.v * y;
    return root + root * (0.5F - root * (0.5F * y));
}
/// sqrt(a) for a >= 0; 0 below 1e-30.
inline Lanes sqrt(Lanes a) { return select(a > Lanes(1e-30F), distance(max(a, Lanes(1e-30F))), Lanes(0)); }

// --- clusters of four in sixteen lanes
// ---------------------------------------------------------------------------------

/// Four candidates, for each of the four targets: lane l gets entry l%4.
inline FloatVector candidates_in_lanes(const float* four) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatVector>(_mm512_maskz_broadcast_f32x4(detail::all_lanes, _mm_loadu_ps(four)));
#else
    FloatFour f;
    __builtin_memcpy(&f, four, sizeof f);
    return __builtin_shufflevector(f, f, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3);
#endif
}
inline IntVector candidates_in_lanes(const std::int32_t* four) {
#if defined(__AVX512F__)
    return reinterpret_cast<IntVector>(
        _mm512_maskz_broadcast_i32x4(detail::all_lanes, _mm_loadu_si128(reinterpret_cast<const __m128i*>(four))));
#else
    IntFour f;
    __builtin_memcpy(&f, four, sizeof f);
    return __builtin_shufflevector(f, f, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3);
#endif
}
/// Four targets, each for four candidates: lane l gets entry l/4.
inline FloatVector targets_in_lanes(const float* four) {
    FloatFour f;
    __builtin_memcpy(&f, four, sizeof f);
    return __builtin_shufflevector(f, f, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
}
inline IntVector targets_in_lanes(const std::int32_t* four) {
    IntFour f;
    __builtin_memcpy(&f, four, sizeof f);
    return __builtin_shufflevector(f, f, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
}
/// Sums over the candidates of each target: entry t adds up lanes 4 t to 4 t + 3, in a fixed order.
inline FloatFour sum_of_candidates(Lanes a) {
    const FloatVector pairs =
        a.v + __builtin_shufflevector(a.v, a.v, 1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14);
    const FloatVector sums =
        pairs + __builtin_shufflevector(pairs, pairs, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13);
    return __builtin_shufflevector(sums, sums, 0, 4, 8, 12);
}
/// Sums over the targets of each candidate, of four numbers: entry 4 k + c adds up lanes c, 4 + c, 8 + c, 12 + c of
/// number k, in a fixed order.
inline FloatVector sums_of_targets(Lanes a, Lanes b, Lanes c, Lanes d) {
    const auto halves = [](FloatVector x, FloatVector y) -> FloatVector {
        return __builtin_shufflevector(x, y, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23) +
               __builtin_shufflevector(x, y, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
    };
    const FloatVector x = halves(a.v, b.v), y = halves(c.v, d.v);
    return __builtin_shufflevector(x, y, 0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27) +
           __builtin_shufflevector(x, y, 4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31);
}
/// Of two numbers, and of one.
inline FloatEight sums_of_targets(Lanes a, Lanes b) {
    const FloatVector x =
        __builtin_shufflevector(a.v, b.v, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23) +
        __builtin_shufflevector(a.v, b.v, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
    return __builtin_shufflevector(x, x, 0, 1, 2, 3, 8, 9, 10, 11) +
           __builtin_shufflevector(x, x, 4, 5, 6, 7, 12, 13, 14, 15);
}
inline FloatFour sums_of_targets(Lanes a) {
    const FloatEight x = __builtin_shufflevector(a.v, a.v, 0, 1, 2, 3, 4, 5, 6, 7) +
                         __builtin_shufflevector(a.v, a.v, 8, 9, 10, 11, 12, 13, 14, 15);
    return __builtin_shufflevector(x, x, 0, 1, 2, 3) + __builtin_shufflevector(x, x, 4, 5, 6, 7);
}
/// memory += values
template <class Vector>
inline void add_to(float* memory, Vector values) {
    Vector before;
    __builtin_memcpy(&before, memory, sizeof before);
    before += values;
    __builtin_memcpy(memory, &before, sizeof before);
}
/// Writes the values of the lanes whose bits are set one after the other, and garbage up to 16 behind them.
/// @returns how many
inline int write_selected(std::uint32_t bits, IntVector values, std::int32_t* out) {
#if defined(__AVX512F__)
    _mm512_storeu_si512(out,
                        _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), reinterpret_cast<__m512i>(values)));
#else
    std::int32_t* next = out;
    for (int lane = 0; lane < lane_count; ++lane) {
        *next = values[lane];
        next += (bits >> lane) & 1U;
    }
#endif
    return __builtin_popcount(bits);
}
/// Difference of whole numbers, modulo 2^32, as floats.
inline Lanes difference(IntVector a, IntVector b) {
    using Unsigned [[gnu::vector_size(sizeof(IntVector))]] = std::uint32_t;
    const auto d = reinterpret_cast<Unsigned>(a) - reinterpret_cast<Unsigned>(b);
    return __builtin_convertvector(reinterpret_cast<IntVector>(d), FloatVector);
}
inline FloatFour difference(IntFour a, IntFour b) {
    using Unsigned [[gnu::vector_size(sizeof(IntFour))]] = std::uint32_t;
    const auto d = reinterpret_cast<Unsigned>(a) - reinterpret_cast<Unsigned>(b);
    return __builtin_convertvector(reinterpret_cast<IntFour>(d), FloatFour);
}
/// Bit l is set where lane l is below the limit.
inline std::uint32_t bits_below(Lanes a, float limit) {
#if defined(__AVX512F__)
    return _mm512_cmp_ps_mask(reinterpret_cast<__m512>(a.v), _mm512_set1_ps(limit), _CMP_LT_OQ);
#elif defined(__AVX2__)
    struct Halves {
        __m256 low, high;
    } h;
    __builtin_memcpy(&h, &a.v, sizeof h);
    const __m256 most = _mm256_set1_ps(limit);
    const auto low = static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(h.low, most, _CMP_LT_OQ)));
    const auto high = static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(h.high, most, _CMP_LT_OQ)));
    return low | high << 8U;
#else
    std::uint32_t bits = 0;
    for (int lane = 0; lane < lane_count; ++lane) {
        bits |= static_cast<std::uint32_t>(a.v[lane] < limit) << lane;
    }
    return bits;
#endif
}

}  // namespace riprap::fluid
