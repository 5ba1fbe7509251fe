// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/core/vec3.hpp"
#include "riprap/core/wide.hpp"

namespace riprap::solid::sphere_dem {

/// Contacts that are computed side by side.
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

/// Vectors of eight rows of an array of Vec3.
inline Vec3x8 gather(const Vec3* base, const RowIndex& index) {
    return {gather<3>(&base->x, index), gather<3>(&base->y, index), gather<3>(&base->z, index)};
}

/// Writes lane `lane` of three numbers.
inline Vec3 lane_of(const Vec3x8& v, std::int64_t lane) { return {v.x[lane], v.y[lane], v.z[lane]}; }

}  // namespace riprap::solid::sphere_dem
