// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sixteen floats side by side: lane l stands for target l/4 and candidate l%4 of two clusters of four. Their arithmetic
// is in core/wide.hpp.

#include <cstdint>

#include "riprap/core/wide_floats.hpp"

namespace riprap::fluid {

inline constexpr int cluster_size = 4;
inline constexpr int lane_count = cluster_size * cluster_size;

using Lanes = Wide<float, lane_count>;
using IntLanes = Wide<std::int32_t, lane_count>;
/// As many of them as the machine takes at once: pair physics works on one part after the other, since all of them
/// would not fit into the sixteen registers of AVX2.
using LanePart = Wide<float, Lanes::part_size>;
inline LanePart part_of(Lanes a, std::size_t k) {
    LanePart part;
    part.part[0] = a.part[k];
    return part;
}

using FloatFour = riprap::detail::VectorOf<float, 4>::Type;
using IntFour = riprap::detail::VectorOf<std::int32_t, 4>::Type;
using DoubleFour = riprap::detail::VectorOf<double, 4>::Type;
using FloatEight = riprap::detail::VectorOf<float, 8>::Type;

namespace detail {

/// Lanes of one part: four numbers over and over,
template <class Part, class Four>
inline Part repeated(Four f) {
    if constexpr (sizeof(Part) == sizeof(Four)) {
        return f;
    } else if constexpr (sizeof(Part) == 2 * sizeof(Four)) {
        return __builtin_shufflevector(f, f, 0, 1, 2, 3, 0, 1, 2, 3);
    } else {
        return __builtin_shufflevector(f, f, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3);
    }
}
/// or each of them four times, of which this is part k.
template <class Part, class Four>
inline Part stretched(Four f, std::size_t k) {
    if constexpr (sizeof(Part) == sizeof(Four)) {
        return f[k] - Part{};
    } else if constexpr (sizeof(Part) == 2 * sizeof(Four)) {
        return k == 0 ? __builtin_shufflevector(f, f, 0, 0, 0, 0, 1, 1, 1, 1)
                      : __builtin_shufflevector(f, f, 2, 2, 2, 2, 3, 3, 3, 3);
    } else {
        return __builtin_shufflevector(f, f, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
    }
}
template <class Four, class T>
inline Four four_at(const T* p) {
    Four f;
    __builtin_memcpy(&f, p, sizeof f);
    return f;
}

// Templates below, so that shuffles of other machines' parts are not looked at.

/// Sums over each four lanes of a part, at the first of the four, in a fixed order.
template <class Part>
inline Part sums_of_fours(Part a) {
    if constexpr (Lanes::part_size == 16) {
        a += __builtin_shufflevector(a, a, 1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14);
        return a + __builtin_shufflevector(a, a, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13);
    } else if constexpr (Lanes::part_size == 8) {
        a += __builtin_shufflevector(a, a, 1, 0, 3, 2, 5, 4, 7, 6);
        return a + __builtin_shufflevector(a, a, 2, 3, 0, 1, 6, 7, 4, 5);
    } else {
        a += __builtin_shufflevector(a, a, 1, 0, 3, 2);
        return a + __builtin_shufflevector(a, a, 2, 3, 0, 1);
    }
}

}  // namespace detail

/// Four candidates, for each of the four targets: lane l gets entry l%4.
template <class T>
inline Wide<T, lane_count> candidates_in_lanes(const T* four) {
    using Part = typename Wide<T, lane_count>::Part;
#if defined(__AVX512F__)
    return Wide<T, lane_count>::each([&](std::size_t) {
        return reinterpret_cast<Part>(_mm512_maskz_broadcast_f32x4(0xFFFF, detail::four_at<__m128>(four)));
    });
#else
    using Four [[gnu::vector_size(cluster_size * sizeof(T))]] = T;
    return Wide<T, lane_count>::each([&](std::size_t) { return detail::repeated<Part>(detail::four_at<Four>(four)); });
#endif
}
/// Four targets, each for four candidates: lane l gets entry l/4.
template <class T>
inline Wide<T, lane_count> targets_in_lanes(const T* four) {
    using Part = typename Wide<T, lane_count>::Part;
    using Four [[gnu::vector_size(cluster_size * sizeof(T))]] = T;
    return Wide<T, lane_count>::each(
        [&](std::size_t k) { return detail::stretched<Part>(detail::four_at<Four>(four), k); });
}
/// Sums over the candidates of each target: entry t adds up lanes 4 t to 4 t + 3, in a fixed order.
template <class Sixteen = Lanes>
inline Wide<float, 4> sum_of_candidates(Sixteen a) {
    const Sixteen sums = Sixteen::each([&](std::size_t k) { return detail::sums_of_fours(a.part[k]); });
    Wide<float, 4> four;
    if constexpr (Lanes::part_size == 4) {
        four.part[0] = FloatFour{sums[0], sums[4], sums[8], sums[12]};
    } else {
        four.part[0] = __builtin_shufflevector(sums.part[0], sums.part[Sixteen::part_count - 1], 0, 4, 8, 12);
    }
    return four;
}
/// Sums over the targets of each candidate, of two numbers that are summed over their parts already: entry 4 k + c adds
/// up the lanes of candidate c of number k, in a fixed order.
template <class Part = LanePart>
inline Wide<float, 8> sums_of_targets(Part a, Part b) {
    Wide<float, 8> sums;
    if constexpr (Lanes::part_size == 16) {
        const auto x =
            __builtin_shufflevector(a.part[0], b.part[0], 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23) +
            __builtin_shufflevector(a.part[0], b.part[0], 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
        sums.part[0] = __builtin_shufflevector(x, x, 0, 1, 2, 3, 8, 9, 10, 11) +
                       __builtin_shufflevector(x, x, 4, 5, 6, 7, 12, 13, 14, 15);
    } else if constexpr (Lanes::part_size == 8) {
        sums.part[0] = __builtin_shufflevector(a.part[0], b.part[0], 0, 1, 2, 3, 8, 9, 10, 11) +
                       __builtin_shufflevector(a.part[0], b.part[0], 4, 5, 6, 7, 12, 13, 14, 15);
    } else {
        sums.part[0] = a.part[0];
        sums.part[1] = b.part[0];
    }
    return sums;
}
/// Of four numbers, and of one.
template <class Part = LanePart>
inline Lanes sums_of_targets(Part a, Part b, Part c, Part d) {
    Lanes sums;
    if constexpr (Lanes::part_size == 16) {
        const auto halves = [](auto x, auto y) {
            return __builtin_shufflevector(x, y, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23) +
                   __builtin_shufflevector(x, y, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
        };
        const auto x = halves(a.part[0], b.part[0]), y = halves(c.part[0], d.part[0]);
        sums.part[0] = __builtin_shufflevector(x, y, 0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27) +
                       __builtin_shufflevector(x, y, 4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31);
    } else {
        const auto x = sums_of_targets<Part>(a, b), y = sums_of_targets<Part>(c, d);
        constexpr std::size_t half = Lanes::part_count / 2;
        for (std::size_t k = 0; k < half; ++k) {
            sums.part[k] = x.part[k];
            sums.part[half + k] = y.part[k];
        }
    }
    return sums;
}
inline Wide<float, 4> sums_of_targets(LanePart a) {
    const Wide<float, 8> sums = sums_of_targets(a, a);
    Wide<float, 4> four;
    __builtin_memcpy(&four, &sums, sizeof four);
    return four;
}
/// memory += values
template <std::size_t N>
inline void add_to(float* memory, Wide<float, N> values) {
    (Wide<float, N>::load(memory) + values).store(memory);
}
/// Writes first + l for every bit l that is set, ascending; may write anything up to 16 places behind `out`.
/// @returns how many
inline int write_selected(std::uint32_t bits, std::int32_t first, std::int32_t* out) {
    const int count = __builtin_popcount(bits);
#if defined(__AVX512F__)
    const __m512i steps = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const __m512i numbers = _mm512_add_epi32(steps, _mm512_set1_epi32(first));
    _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), numbers));
#else
    for (; bits != 0; bits &= bits - 1) {
        *out++ = first + __builtin_ctz(bits);
    }
#endif
    return count;
}
/// Difference of whole numbers, modulo 2^32, as floats.
inline Lanes difference(IntLanes a, IntLanes b) {
    using Unsigned [[gnu::vector_size(sizeof(IntLanes::Part))]] = std::uint32_t;
    return Lanes::each([&](std::size_t k) {
        const auto d = reinterpret_cast<Unsigned>(a.part[k]) - reinterpret_cast<Unsigned>(b.part[k]);
        return __builtin_convertvector(reinterpret_cast<IntLanes::Part>(d), Lanes::Part);
    });
}
inline FloatFour difference(IntFour a, IntFour b) {
    using Unsigned [[gnu::vector_size(sizeof(IntFour))]] = std::uint32_t;
    const auto d = reinterpret_cast<Unsigned>(a) - reinterpret_cast<Unsigned>(b);
    return __builtin_convertvector(reinterpret_cast<IntFour>(d), FloatFour);
}

}  // namespace riprap::fluid
