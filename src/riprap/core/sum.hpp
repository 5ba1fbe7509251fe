// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sums over many entities, with the same bits at any thread count, on host and device, and however the blocks of the
// entities are dealt out. Within a block of `reduce_block` entries, chains of `sum_chain` are added up in index order,
// and the chains in theirs; blocks are added up exactly (core/exact_sum.hpp), so no result has an order of blocks.

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "riprap/core/exact_sum.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/vec3.hpp"

namespace riprap::parallel {

/// Entries that are added up one after the other before chains are; part of the definition of a sum.
inline constexpr std::int64_t sum_chain = 64;

/// Joins two partial results. A struct of sums has a member
///
///     template <class By>
///     RIPRAP_HD static void join(Sums& a, const Sums& b, const By& by) {
///         by.add(a.work, b.work);         // a double, a Vec3, an integer, or another struct with `join`
///         by.largest(a.speed, b.speed);
///     }
///
/// which is the one list of what is added up and what is not. `Add(double&, double)` is told by whoever joins. What
/// `join` does by itself with other members has to be free of order. A struct made by default is the result of nothing.
template <class Add>
struct JoinBy {
    Add add_number;

    template <class T>
    RIPRAP_HD void add(T& a, const T& b) const {
        if constexpr (std::is_same_v<T, double>) {
            add_number(a, b);
        } else if constexpr (std::is_integral_v<T>) {
            a += b;
        } else if constexpr (std::is_same_v<T, Vec3>) {
            add_number(a.x, b.x);
            add_number(a.y, b.y);
            add_number(a.z, b.z);
        } else {
            T::join(a, b, *this);
        }
    }
    /// A number that is none loses.
    template <class T>
    RIPRAP_HD void largest(T& a, const T& b) const {
        a = a < b ? b : a;
    }
};

/// Rounds each sum: within blocks.
struct AddRounded {
    RIPRAP_HD void operator()(double& a, double b) const { a += b; }
};

/// Adds map(i) for i in [begin, end) in chains: a block, or a part of one.
template <class T, class Map>
RIPRAP_HD T sum_in_chains(std::int64_t begin, std::int64_t end, const Map& map) {
    const JoinBy<AddRounded> by{};
    T total{};
    for (std::int64_t first = begin; first < end; first += sum_chain) {
        const std::int64_t last = first + sum_chain < end ? first + sum_chain : end;
        T chain{};
        for (std::int64_t i = first; i < last; ++i) {
            by.add(chain, map(i));
        }
        by.add(total, chain);
    }
    return total;
}

/// Exact sum of what blocks gave, in any order and grouping. T is a double, a Vec3 or a struct with `join`.
template <class T>
class Total {
 public:
    void add(const T& block) {
        std::size_t next = 0;
        join(block, [&](double&, double b) { sum(next++).add(b); });
    }
    /// Adds the blocks of another holder.
    void add(const Total& other) {
        std::size_t next = 0;
        join(other.rest_, [&](double&, double) {
            if (next < other.sums_.size()) {
                sum(next).add(other.sums_[next]);
            }
            ++next;
        });
    }
    /// Returns the sums, each rounded once, and what `join` made of other members.
    T value() const {
        T result = rest_;
        std::size_t next = 0;
        const auto take = [&](double& a, double) {
            a = next < sums_.size() ? sums_[next].value() : 0;
            ++next;
        };
        const T nothing{};
        JoinBy<decltype(take)>{take}.add(result, nothing);
        return result;
    }

 private:
    template <class Add>
    void join(const T& b, const Add& add) {
        JoinBy<Add>{add}.add(rest_, b);
    }
    ExactSum& sum(std::size_t number) {
        if (number == sums_.size()) {
            sums_.emplace_back();
        }
        return sums_[number];
    }

    T rest_{};
    std::vector<ExactSum> sums_;
};

/// Returns the exact sum of what blocks gave.
template <class T>
T total_of(const std::vector<T>& blocks) {
    if (blocks.size() <= 2) {  // a + b is the nearest double to the exact sum already
        T total{};
        for (const T& block : blocks) {
            JoinBy<AddRounded>{}.add(total, block);
        }
        return total;
    }
    Total<T> total;
    for (const T& block : blocks) {
        total.add(block);
    }
    return total.value();
}

/// Names what a map of entries returns.
template <class Map>
using SumOf = std::remove_cvref_t<std::invoke_result_t<const Map&, std::int64_t>>;

/// Returns map(0) + ... + map(n - 1): a double, a Vec3, or a struct with `join`. `block` is part of the definition of a
/// result; a smaller one lets a costly map share its work at small n, and 1 is for entries that are blocks already.
template <class Map>
SumOf<Map> sum(std::int64_t n, const Map& map, std::int64_t block = reduce_block) {
    using T = SumOf<Map>;
    std::vector<T> blocks(static_cast<std::size_t>((n + block - 1) / block));
    detail::for_chunks(n, block, [&](std::int64_t begin, std::int64_t end) {
        blocks[static_cast<std::size_t>(begin / block)] = sum_in_chains<T>(begin, end, map);
    });
    return total_of(blocks);
}

/// Returns the sum of map(i) with every entry added exactly, for entries without a global order of their own, as
/// contacts are: whoever has them may add them up in any order.
template <class Map>
SumOf<Map> sum_exactly(std::int64_t n, const Map& map) {
    constexpr std::int64_t grain = 1024;
    std::vector<Total<SumOf<Map>>> parts(static_cast<std::size_t>(std::max<std::int64_t>(1, (n + grain - 1) / grain)));
    detail::for_chunks(n, grain, [&](std::int64_t begin, std::int64_t end) {
        Total<SumOf<Map>>& part = parts[static_cast<std::size_t>(begin / grain)];
        for (std::int64_t i = begin; i < end; ++i) {
            part.add(map(i));
        }
    });
    for (std::size_t k = 1; k < parts.size(); ++k) {
        parts[0].add(parts[k]);
    }
    return parts[0].value();
}

}  // namespace riprap::parallel
