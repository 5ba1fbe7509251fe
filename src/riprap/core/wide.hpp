// SPDX-License-Identifier: Apache-2.0
#pragma once

// Numbers side by side, cut into the vectors that the machine calculates with. GCC takes vectors wider than those of
// the machine too, but keeps them in memory and compares them number by number, several times slower than this.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace riprap {

/// Bytes of the machine's widest vector of numbers.
#if defined(__AVX512F__)
inline constexpr std::size_t vector_bytes = 64;
#elif defined(__AVX2__)
inline constexpr std::size_t vector_bytes = 32;
#else
inline constexpr std::size_t vector_bytes = 16;
#endif

namespace detail {

/// A vector type of Count numbers (extension of GCC and Clang).
template <class T, std::size_t Count>
struct VectorOf {
    using Type [[gnu::vector_size(Count * sizeof(T))]] = T;
};

/// a where a < b, else b, number by number: what the machine's own minimum gives, NaN and signed zero included.
template <class Part>
inline Part lesser(Part a, Part b) {
    return a < b ? a : b;
}
template <class Part>
inline Part greater(Part a, Part b) {
    return a > b ? a : b;
}
/// Square root, number by number.
template <class Part>
inline Part root(Part a) {
    for (std::size_t lane = 0; lane < sizeof(a) / sizeof(a[0]); ++lane) {
        a[lane] = std::sqrt(a[lane]);
    }
    return a;
}
/// One bit per number.
template <class Part>
inline std::uint32_t bits_below(Part a, Part b) {
    std::uint32_t bits = 0;
    for (std::size_t lane = 0; lane < sizeof(a) / sizeof(a[0]); ++lane) {
        bits |= static_cast<std::uint32_t>(a[lane] < b[lane]) << lane;
    }
    return bits;
}

#if defined(__AVX2__)
using FloatEight = VectorOf<float, 8>::Type;
using DoubleFour = VectorOf<double, 4>::Type;
inline FloatEight lesser(FloatEight a, FloatEight b) { return _mm256_min_ps(a, b); }
inline FloatEight greater(FloatEight a, FloatEight b) { return _mm256_max_ps(a, b); }
inline DoubleFour lesser(DoubleFour a, DoubleFour b) { return _mm256_min_pd(a, b); }
inline DoubleFour greater(DoubleFour a, DoubleFour b) { return _mm256_max_pd(a, b); }
inline DoubleFour root(DoubleFour a) { return _mm256_sqrt_pd(a); }
inline std::uint32_t bits_below(FloatEight a, FloatEight b) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)));
}
inline std::uint32_t bits_below(DoubleFour a, DoubleFour b) {
    return static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
}
#endif
#if defined(__AVX512F__)
// The masked forms with all lanes on: the same instructions, without GCC 12's warning of an uninitialised register.
using FloatSixteen = VectorOf<float, 16>::Type;
using DoubleEight = VectorOf<double, 8>::Type;
inline FloatSixteen lesser(FloatSixteen a, FloatSixteen b) { return _mm512_maskz_min_ps(0xFFFF, a, b); }
inline FloatSixteen greater(FloatSixteen a, FloatSixteen b) { return _mm512_maskz_max_ps(0xFFFF, a, b); }
inline DoubleEight lesser(DoubleEight a, DoubleEight b) { return _mm512_maskz_min_pd(0xFF, a, b); }
inline DoubleEight greater(DoubleEight a, DoubleEight b) { return _mm512_maskz_max_pd(0xFF, a, b); }
inline DoubleEight root(DoubleEight a) { return _mm512_maskz_sqrt_pd(0xFF, a); }
inline std::uint32_t bits_below(FloatSixteen a, FloatSixteen b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
inline std::uint32_t bits_below(DoubleEight a, DoubleEight b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
#endif

}  // namespace detail

/// N numbers with element-wise arithmetic; N is a power of two.
template <class T, std::size_t N>
struct Wide {
    static_assert(N > 1 && (N & (N - 1)) == 0, "numbers side by side come in powers of two");
    static constexpr std::size_t part_size = N < vector_bytes / sizeof(T) ? N : vector_bytes / sizeof(T);
    static constexpr std::size_t part_count = N / part_size;
    using Part = typename detail::VectorOf<T, part_size>::Type;
    using Parts = std::make_index_sequence<part_count>;

    Part part[part_count];

    Wide() = default;  ///< of no value, as a number; Wide{} is zero
    /// One number in all lanes.
    template <class Number>
    requires std::is_arithmetic_v<Number>
    explicit Wide(Number a) : Wide(each([&](std::size_t) { return static_cast<T>(a) - Part{}; })) {}

    /// The part that `f` makes of each part's number.
    template <class F>
    [[gnu::always_inline]] static Wide each(const F& f) {
        return each(f, Parts{});
    }
    // part by part: GCC would copy the whole in shorter pieces, which hold up the loads of parts
    static Wide load(const T* from) {
        return each([&](std::size_t k) {
            Part p;
            __builtin_memcpy(&p, from + k * part_size, sizeof p);
            return p;
        });
    }
    void store(T* to) const { store(to, Parts{}); }
    /// The number of one lane.
    T operator[](std::int64_t lane) const { return part[lane / width][lane % width]; }
    void set(std::int64_t lane, T a) { part[lane / width][lane % width] = a; }

    Wide& operator+=(Wide b) { return *this = *this + b; }
    Wide& operator-=(Wide b) { return *this = *this - b; }
    Wide& operator*=(Wide b) { return *this = *this * b; }

    friend Wide operator+(Wide a, Wide b) {
        return each([&](std::size_t k) { return a.part[k] + b.part[k]; });
    }
    friend Wide operator-(Wide a, Wide b) {
        return each([&](std::size_t k) { return a.part[k] - b.part[k]; });
    }
    friend Wide operator*(Wide a, Wide b) {
        return each([&](std::size_t k) { return a.part[k] * b.part[k]; });
    }
    friend Wide operator/(Wide a, Wide b) {
        return each([&](std::size_t k) { return a.part[k] / b.part[k]; });
    }
    friend Wide operator-(Wide a) {
        return each([&](std::size_t k) { return -a.part[k]; });
    }
    friend Wide operator*(T a, Wide b) { return Wide(a) * b; }
    friend Wide operator*(Wide a, T b) { return a * Wide(b); }

 private:
    static constexpr auto width = static_cast<std::int64_t>(part_size);
    template <class F, std::size_t... K>
    [[gnu::always_inline]] static Wide each(const F& f, std::index_sequence<K...>) {
        Wide a;
        ((a.part[K] = f(K)), ...);
        return a;
    }
    template <std::size_t... K>
    [[gnu::always_inline]] void store(T* to, std::index_sequence<K...>) const {
        (__builtin_memcpy(to + K * part_size, &part[K], sizeof(Part)), ...);
    }
};

/// Truth per lane: all bits of a number or none.
template <class T, std::size_t N>
using WideMask = Wide<std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>, N>;

template <class T, std::size_t N>
inline WideMask<T, N> operator<(Wide<T, N> a, Wide<T, N> b) {
    return WideMask<T, N>::each([&](std::size_t k) { return a.part[k] < b.part[k]; });
}
template <class T, std::size_t N>
inline WideMask<T, N> operator>(Wide<T, N> a, Wide<T, N> b) {
    return b < a;
}
template <class T, std::size_t N>
inline WideMask<T, N> operator<=(Wide<T, N> a, Wide<T, N> b) {
    return WideMask<T, N>::each([&](std::size_t k) { return a.part[k] <= b.part[k]; });
}
template <class T, std::size_t N>
inline WideMask<T, N> operator>=(Wide<T, N> a, Wide<T, N> b) {
    return b <= a;
}
template <class T, std::size_t N>
inline WideMask<T, N> operator==(Wide<T, N> a, Wide<T, N> b) {
    return WideMask<T, N>::each([&](std::size_t k) { return a.part[k] == b.part[k]; });
}
template <class Int, std::size_t N>
inline Wide<Int, N> operator&(Wide<Int, N> a, Wide<Int, N> b) {
    return Wide<Int, N>::each([&](std::size_t k) { return a.part[k] & b.part[k]; });
}
template <class Int, std::size_t N>
inline Wide<Int, N> operator|(Wide<Int, N> a, Wide<Int, N> b) {
    return Wide<Int, N>::each([&](std::size_t k) { return a.part[k] | b.part[k]; });
}
/// a where the condition holds, else b.
template <class Int, class T, std::size_t N>
inline Wide<T, N> select(Wide<Int, N> condition, Wide<T, N> a, Wide<T, N> b) {
    return Wide<T, N>::each([&](std::size_t k) { return condition.part[k] ? a.part[k] : b.part[k]; });
}
template <class T, std::size_t N>
inline Wide<T, N> min(Wide<T, N> a, Wide<T, N> b) {
    return Wide<T, N>::each([&](std::size_t k) { return detail::lesser(a.part[k], b.part[k]); });
}
template <class T, std::size_t N>
inline Wide<T, N> sqrt(Wide<T, N> a) {
    return Wide<T, N>::each([&](std::size_t k) { return detail::root(a.part[k]); });
}
template <class T, std::size_t N>
inline Wide<T, N> max(Wide<T, N> a, Wide<T, N> b) {
    return Wide<T, N>::each([&](std::size_t k) { return detail::greater(a.part[k], b.part[k]); });
}
/// Bit l is set where a < b in lane l.
template <class T, std::size_t N>
inline std::uint32_t bits_below(Wide<T, N> a, Wide<T, N> b) {
    using W = Wide<T, N>;
    static_assert(N <= 32);
    return [&]<std::size_t... K>(std::index_sequence<K...>) {
        return ((detail::bits_below(a.part[K], b.part[K]) << (K * W::part_size)) | ...);
    }
    (typename W::Parts{});
}

}  // namespace riprap
