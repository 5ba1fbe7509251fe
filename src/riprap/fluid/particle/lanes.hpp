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
/// sqrt(a) for a >= 0; 0 below 1e-30.
inline Lanes sqrt(Lanes a) { return a * reciprocal_sqrt(max(a, Lanes(1e-30F))); }

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
/// Difference of whole numbers, modulo 2^32, as floats.
inline Lanes difference(IntVector a, IntVector b) {
    using Unsigned [[gnu::vector_size(sizeof(IntVector))]] = std::uint32_t;
    return __builtin_convertvector(
        reinterpret_cast<IntVector>(reinterpret_cast<Unsigned>(a) - reinterpret_cast<Unsigned>(b)), FloatVector);
}
/// Bit l is set where lane l is below the limit.
inline std::uint32_t bits_below(Lanes a, float limit) {
#if defined(__AVX512F__)
    return _mm512_cmp_ps_mask(reinterpret_cast<__m512>(a.v), _mm512_set1_ps(limit), _CMP_LT_OQ);
#else
    std::uint32_t bits = 0;
    for (int lane = 0; lane < lane_count; ++lane) {
        bits |= static_cast<std::uint32_t>(a.v[lane] < limit) << lane;
    }
    return bits;
#endif
}

}  // namespace riprap::fluid
