// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// Stores that go past the caches, for arrays that are larger than they are: a line that is written whole need not be
// read from memory first.

namespace riprap::linear {

/// Copies `count` numbers, a multiple of eight, to a place that begins with a line; both begin at multiples of 64
/// bytes. Other threads see them after finish_stores().
inline void store_past_caches(const double* from, std::size_t count, double* to) {
#if defined(__AVX512F__)
    for (std::size_t i = 0; i < count; i += 8) {
        _mm512_stream_pd(to + i, _mm512_load_pd(from + i));
    }
#elif defined(__AVX2__)
    for (std::size_t i = 0; i < count; i += 4) {
        _mm256_stream_pd(to + i, _mm256_load_pd(from + i));
    }
#elif defined(__SSE2__)
    for (std::size_t i = 0; i < count; i += 2) {
        _mm_stream_pd(to + i, _mm_load_pd(from + i));
    }
#else
    std::copy_n(from, count, to);
#endif
}

/// Makes the stores of this thread visible to others before whatever it writes next.
inline void finish_stores() {
#if defined(__SSE2__)
    _mm_sfence();
#endif
}

}  // namespace riprap::linear
