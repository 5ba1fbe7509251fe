// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>

#include "riprap/core/vec3.hpp"
#include "riprap/core/wide.hpp"
#include "riprap/solid/transposed.hpp"

namespace riprap::solid {

/// Contacts or bodies of a group: sums over groups have the same bits on every machine.
inline constexpr std::int64_t lanes = 8;
using Eight = Wide<double, 8>;
using Vec3x8 = Vec3T<Eight>;
/// One vector of the machine. Long formulas go through a group by such parts, which leaves their values in registers.
using Native = Wide<double, transposed::width>;
inline constexpr std::int64_t parts = lanes / transposed::width;

/// Numbers of T.
template <class T>
inline constexpr std::int64_t lanes_in = sizeof(T) / sizeof(double);

/// work(lane) of every lane of T, written out: GCC would make vectors of a loop over places.
template <class T, class Work>
[[gnu::always_inline]] inline void for_lanes(const Work& work) {
    [&]<std::int64_t... Lane>(std::integer_sequence<std::int64_t, Lane...>) { (work(Lane), ...); }
    (std::make_integer_sequence<std::int64_t, lanes_in<T>>{});
}

/// Rows of a table, one per lane of T.
template <class T>
struct RowsOf {
    std::int32_t row[lanes_in<T>];
};

/// Four numbers of each row.
template <class T>
struct FourOf {
    T a, b, c, d;
};

/// Numbers base[row * Stride], one row per lane of T.
template <int Stride, class T>
inline T gather(const double* base, const RowsOf<T>& rows) {
    T out{};
    for (std::int64_t lane = 0; lane < lanes_in<T>; ++lane) {
        out.set(lane, base[static_cast<std::int64_t>(rows.row[lane]) * Stride]);
    }
    return out;
}
/// Vectors of an array, one row per lane of T.
template <class T>
inline Vec3T<T> gather(const Vec3* base, const RowsOf<T>& rows) {
    return {gather<3>(&base->x, rows), gather<3>(&base->y, rows), gather<3>(&base->z, rows)};
}

/// Four numbers at each place, one place per lane of T.
template <class T>
[[gnu::always_inline]] inline FourOf<T> load_four(const double* const* at) {
    FourOf<T> out;
    for (std::size_t p = 0; p < T::part_count; ++p) {
        transposed::load_four(at + p * T::part_size, out.a.part[p], out.b.part[p], out.c.part[p], out.d.part[p]);
    }
    return out;
}
/// Numbers base[row * Stride] to base[row * Stride + 3], one row per lane of T.
template <int Stride, class T>
[[gnu::always_inline]] inline FourOf<T> load_four(const double* base, const RowsOf<T>& rows) {
    const double* at[lanes_in<T>];
    for_lanes<T>([&](std::int64_t k) { at[k] = base + static_cast<std::int64_t>(rows.row[k]) * Stride; });
    return load_four<T>(at);
}

/// Writes four numbers at each place.
template <class T>
[[gnu::always_inline]] inline void store_four(const FourOf<T>& from, double* const* to) {
    for (std::size_t p = 0; p < T::part_count; ++p) {
        transposed::store_four(from.a.part[p], from.b.part[p], from.c.part[p], from.d.part[p], to + p * T::part_size);
    }
}

/// Two vectors of each lane, side by side in memory.
[[gnu::always_inline]] inline transposed::SixRows six_rows(const Vec3T<Native>& front, const Vec3T<Native>& back) {
    return transposed::SixRows(
        {front.x.part[0], front.y.part[0], front.z.part[0], back.x.part[0], back.y.part[0], back.z.part[0]});
}

/// Vectors in a row, from memory to lanes and back.
template <class T = Eight>
[[gnu::always_inline]] inline Vec3T<T> load_vectors(const Vec3* from) {
    Vec3T<T> v;
    for (std::size_t p = 0; p < T::part_count; ++p) {
        transposed::load_three(&from[p * T::part_size].x, v.x.part[p], v.y.part[p], v.z.part[p]);
    }
    return v;
}
template <class T>
[[gnu::always_inline]] inline void store_vectors(const Vec3T<T>& v, Vec3* to) {
    for (std::size_t p = 0; p < T::part_count; ++p) {
        transposed::store_three(v.x.part[p], v.y.part[p], v.z.part[p], &to[p * T::part_size].x);
    }
}

/// Vector of one lane.
template <class T>
inline Vec3 lane_of(const Vec3T<T>& v, std::int64_t lane) {
    return {v.x[lane], v.y[lane], v.z[lane]};
}

}  // namespace riprap::solid
