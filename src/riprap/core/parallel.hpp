// SPDX-License-Identifier: Apache-2.0
#pragma once

// The only place (with parallel_cuda*.hpp, parallel.cpp and crew.hpp) that knows of threads of loops or of CUDA.
//
// Work is cut by data, never by thread, so results have the same bits at any thread count:
// for_each writes by index; reduce folds fixed blocks of `reduce_block` entries in index order. Sums of numbers with
// rounding go through parallel::sum (core/sum.hpp), which has no order of blocks.
// Functors are free function objects; a device build takes the same ones when they are RIPRAP_HD.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "riprap/core/config.hpp"

namespace riprap::parallel {

/// Number of host threads used by every loop below [-].
int thread_count();
/// Name of the host back end, for the record.
const char* backend_name();
/// Sets the number of host threads, at least 1. May be called while loops run: they take it when they begin.
void set_thread_count(int count);

/// Tells whether loops may write entries of a std::vector<T> at once: not those that share a byte, as bool does.
template <class T>
inline constexpr bool has_own_bytes = !std::is_same_v<std::remove_cv_t<T>, bool>;

/// Entries folded together before partial results are combined; part of the definition of a sum.
inline constexpr std::int64_t reduce_block = 2048;

namespace detail {
/// Runs body(context, chunk) for chunk = 0 .. chunk_count-1 on the host threads, in any order.
void run_chunks(std::int64_t chunk_count, void (*body)(void*, std::int64_t), void* context);

template <class F>
void for_chunks(std::int64_t n, std::int64_t grain, const F& f) {
    struct Context {
        const F* f;
        std::int64_t n, grain;
    } context{&f, n, grain};
    run_chunks((n + grain - 1) / grain,
               [](void* raw, std::int64_t chunk) {
                   const auto& c = *static_cast<Context*>(raw);
                   (*c.f)(chunk * c.grain, std::min(c.n, (chunk + 1) * c.grain));
               },
               &context);
}
}  // namespace detail

/// f(i) for i in [0, n). Entries of equal, small cost: up to 1024 of them are not worth waking a thread for. f may
/// write only what belongs to i.
template <class F>
void for_each(std::int64_t n, const F& f) {
    const std::int64_t threads = thread_count(), grain = std::max<std::int64_t>(1024, (n + threads - 1) / threads);
    detail::for_chunks(n, grain, [&f](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            f(i);
        }
    });
}

/// f(i) for i in [0, n) with uneven cost, `grain` entries at a time: each thread begins with the same contiguous share
/// in loop after loop, which its cache may still hold, and once through with it helps with the others.
template <class F>
void for_each_uneven(std::int64_t n, std::int64_t grain, const F& f) {
    detail::for_chunks(n, grain, [&f](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            f(i);
        }
    });
}

/// f(begin, end) on contiguous ranges of at most `grain` entries, for kernels with per-range set-up.
template <class F>
void for_ranges(std::int64_t n, std::int64_t grain, const F& f) {
    detail::for_chunks(n, grain, f);
}

/// fold(fold(identity, map(0)), map(1)) ... in fixed blocks, for a fold whose result does not depend on how entries are
/// grouped: the largest, the first, a count. A smaller block lets a costly map share its work at small n. What is
/// rounded is summed by parallel::sum.
template <class T, class Map, class Fold>
T reduce(std::int64_t n, const T& identity, const Map& map, const Fold& fold, std::int64_t block = reduce_block) {
    static_assert(has_own_bytes<T>, "bits of a std::vector<bool> share bytes that two threads would write: use any_of");
    const std::int64_t block_count = (n + block - 1) / block;
    std::vector<T> partial(static_cast<std::size_t>(block_count), identity);
    detail::for_chunks(n, block, [&](std::int64_t begin, std::int64_t end) {
        T sum = identity;
        for (std::int64_t i = begin; i < end; ++i) {
            sum = fold(sum, map(i));
        }
        partial[static_cast<std::size_t>(begin / block)] = sum;
    });
    T total = identity;
    for (const T& p : partial) {
        total = fold(total, p);
    }
    return total;
}

/// Tells whether is(i) for any i in [0, n).
template <class Predicate>
bool any_of(std::int64_t n, const Predicate& is) {
    return reduce(
               n, 0, [&is](std::int64_t i) { return is(i) ? 1 : 0; }, [](int a, int b) { return a | b; }) != 0;
}

/// out[i] = in[0] + ... + in[i-1]; returns the total. `out` may be `in`. T is an integer type.
template <class T>
T exclusive_scan(std::span<const T> in, std::span<T> out) {
    static_assert(has_own_bytes<T>, "see reduce");
    const auto n = static_cast<std::int64_t>(in.size());
    const std::int64_t grain = 1 << 14;
    const std::int64_t block_count = (n + grain - 1) / grain;
    std::vector<T> block_sum(static_cast<std::size_t>(block_count));
    detail::for_chunks(n, grain, [&](std::int64_t begin, std::int64_t end) {
        T sum{};
        for (std::int64_t i = begin; i < end; ++i) {
            sum += in[static_cast<std::size_t>(i)];
        }
        block_sum[static_cast<std::size_t>(begin / grain)] = sum;
    });
    T total{};
    for (T& b : block_sum) {
        const T next = total + b;
        b = total;
        total = next;
    }
    detail::for_chunks(n, grain, [&](std::int64_t begin, std::int64_t end) {
        T sum = block_sum[static_cast<std::size_t>(begin / grain)];
        for (std::int64_t i = begin; i < end; ++i) {
            const T value = in[static_cast<std::size_t>(i)];
            out[static_cast<std::size_t>(i)] = sum;
            sum += value;
        }
    });
    return total;
}

/// Sorts 64-bit keys ascending and carries 32-bit values along; stable (radix, 8 bits a pass, passes in
/// which all keys agree are skipped). `scratch_*` are resized as needed and hold nothing of meaning.
void sort_by_key(std::vector<std::uint64_t>& keys, std::vector<std::uint32_t>& values,
                 std::vector<std::uint64_t>& scratch_keys, std::vector<std::uint32_t>& scratch_values);

}  // namespace riprap::parallel
