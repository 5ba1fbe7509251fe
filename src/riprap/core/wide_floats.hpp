// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reciprocals and roots of floats side by side: the machine's estimate and one step of Newton's, 2 units in the last
// place off. Estimates differ between kinds of processors, and with them the last bits of what is made of these.

#include "riprap/core/wide.hpp"

namespace riprap {

namespace detail {

/// 1/a and 1/sqrt(a) to at least 11 bits.
template <class Part>
inline Part estimate_reciprocal(Part a) {
    return 1.0F / a;
}
template <class Part>
inline Part estimate_reciprocal_sqrt(Part a) {
    for (std::size_t lane = 0; lane < sizeof(a) / sizeof(a[0]); ++lane) {
        a[lane] = 1.0F / __builtin_sqrtf(a[lane]);
    }
    return a;
}
#if defined(__AVX2__)
inline FloatEight estimate_reciprocal(FloatEight a) { return _mm256_rcp_ps(a); }
inline FloatEight estimate_reciprocal_sqrt(FloatEight a) { return _mm256_rsqrt_ps(a); }
#endif
#if defined(__AVX512F__)
inline FloatSixteen estimate_reciprocal(FloatSixteen a) { return _mm512_maskz_rcp14_ps(0xFFFF, a); }
inline FloatSixteen estimate_reciprocal_sqrt(FloatSixteen a) { return _mm512_maskz_rsqrt14_ps(0xFFFF, a); }
#endif

}  // namespace detail

/// 1/a for normal a; 0 and infinity may give NaN.
template <std::size_t N>
inline Wide<float, N> reciprocal(Wide<float, N> a) {
    return Wide<float, N>::each([&](std::size_t k) {
        const auto y = detail::estimate_reciprocal(a.part[k]);
        return y + y * (1.0F - a.part[k] * y);
    });
}
/// 1/sqrt(a) for normal a > 0.
template <std::size_t N>
inline Wide<float, N> reciprocal_sqrt(Wide<float, N> a) {
    return Wide<float, N>::each([&](std::size_t k) {
        const auto y = detail::estimate_reciprocal_sqrt(a.part[k]);
        return y + y * (0.5F - 0.5F * a.part[k] * y * y);
    });
}
/// sqrt(a) for normal a > 0, under the name by which pair physics asks for it.
template <std::size_t N>
inline Wide<float, N> distance(Wide<float, N> a) {
    return Wide<float, N>::each([&](std::size_t k) {
        const auto y = detail::estimate_reciprocal_sqrt(a.part[k]);
        const auto root = a.part[k] * y;
        return root + root * (0.5F - root * (0.5F * y));
    });
}
/// sqrt(a) for a >= 0; 0 below 1e-30.
template <std::size_t N>
inline Wide<float, N> sqrt(Wide<float, N> a) {
    const Wide<float, N> least(1e-30F);
    return select(a > least, distance(max(a, least)), Wide<float, N>(0));
}

}  // namespace riprap
