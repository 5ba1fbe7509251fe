// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "riprap/core/parallel.hpp"

namespace riprap::parallel {

/// Entries [begin, end) of an array in its global order. A loop over entities takes the range that it owns; entries
/// beyond it are ghosts, which are read and never written. On one machine all entries are owned.
struct Range {
    std::int64_t begin{0}, end{0};
    constexpr std::int64_t size() const { return end - begin; }
    friend constexpr bool operator==(const Range&, const Range&) = default;
};

/// Calls f(i) for every i of the range, as parallel::for_each.
template <class F>
void for_each(const Range& owned, const F& f) {
    for_each(owned.size(), [&f, begin = owned.begin](std::int64_t i) { f(begin + i); });
}

/// Folds each block of a range on its own and gives it to take(number of the block, partial result), in the order of
/// blocks. Blocks are cut at multiples of `block` in the global order, so that the blocks of ranges that meet at such a
/// multiple are those of the whole: folded in order, they have the bits of parallel::reduce over it.
template <class T, class Map, class Fold, class Take>
void reduce_blocks(const Range& owned, const T& identity, const Map& map, const Fold& fold, const Take& take,
                   std::int64_t block = reduce_block) {
    static_assert(has_own_bytes<T>, "see reduce");
    if (owned.size() <= 0) {
        return;
    }
    const std::int64_t first = owned.begin / block, count = (owned.end + block - 1) / block - first;
    std::vector<T> partial(static_cast<std::size_t>(count), identity);
    for_each_uneven(count, 1, [&](std::int64_t k) {
        T sum = identity;
        const std::int64_t begin = std::max(owned.begin, (first + k) * block);
        const std::int64_t end = std::min(owned.end, (first + k + 1) * block);
        for (std::int64_t i = begin; i < end; ++i) {
            sum = fold(sum, map(i));
        }
        partial[static_cast<std::size_t>(k)] = sum;
    });
    for (std::int64_t k = 0; k < count; ++k) {
        take(first + k, partial[static_cast<std::size_t>(k)]);
    }
}

/// Returns the fold over a range, in blocks of the global order. For all entries it has the bits of parallel::reduce.
template <class T, class Map, class Fold>
T reduce(const Range& owned, const T& identity, const Map& map, const Fold& fold, std::int64_t block = reduce_block) {
    T total = identity;
    reduce_blocks(
        owned, identity, map, fold, [&](std::int64_t, const T& partial) { total = fold(total, partial); }, block);
    return total;
}

}  // namespace riprap::parallel
