// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"

namespace riprap::parallel {

/// A block of `reduce_block` entities that follow each other in their one global order; the last one may be shorter.
struct Block {
    std::int64_t number{0};  ///< in the global order
    bool own{true};          ///< else a ghost: a copy of what another holder decides
    std::int64_t first{0};   ///< place of its first entity in the arrays of the holder
    std::int64_t count{0};   ///< of entities

    friend bool operator==(const Block&, const Block&) = default;
};

/// Blocks that a holder keeps, by ascending number, without gaps in its arrays; empty: all blocks of all entities.
struct BlockTable {
    std::vector<Block> held;
    std::int64_t whole{0};  ///< number of blocks in the global order

    /// Adds the next block of those that are kept, full but for the last one of all.
    void add(std::int64_t number, bool own, std::int64_t count) {
        const std::int64_t first = held.empty() ? 0 : held.back().first + held.back().count;
        held.push_back({number, own, first, count});
    }
};

/// View of the blocks that a holder keeps, of n entities in all. Loops run over own blocks and ghosts alike (a ghost is
/// a copy, so what belongs to it alone may be computed again); sums and extremes are those of own blocks. The sums of
/// all holders, added up as Totals, have the bits of one holder that owns everything.
class Blocks {
 public:
    Blocks(const BlockTable& table, std::int64_t n) : table_(table.held.empty() ? nullptr : &table), n_(n) {}
    /// All blocks of n entities.
    explicit Blocks(std::int64_t n) : n_(n) {}

    bool are_all() const { return table_ == nullptr; }
    /// Number of entities in the arrays of the holder.
    std::int64_t size() const { return n_; }
    /// Number of blocks in the arrays of the holder, and in the global order.
    std::int64_t count() const { return are_all() ? all_count() : static_cast<std::int64_t>(table_->held.size()); }
    std::int64_t whole() const { return are_all() ? all_count() : table_->whole; }
    Block operator[](std::int64_t k) const {
        if (are_all()) {
            return {k, true, k * reduce_block, std::min(reduce_block, n_ - k * reduce_block)};
        }
        return table_->held[static_cast<std::size_t>(k)];
    }

 private:
    std::int64_t all_count() const { return (n_ + reduce_block - 1) / reduce_block; }

    const BlockTable* table_{nullptr};
    std::int64_t n_;
};

/// Calls f(i) for every entity of the holder, as parallel::for_each.
template <class F>
void for_each(const Blocks& blocks, const F& f) {
    for_each(blocks.size(), f);
}

/// Returns what each block gives, summed in chains, ghosts among them.
template <class Map>
std::vector<SumOf<Map>> sums_of_blocks(const Blocks& blocks, const Map& map) {
    using T = SumOf<Map>;
    std::vector<T> sums(static_cast<std::size_t>(blocks.count()));
    for_each_uneven(blocks.count(), 1, [&](std::int64_t k) {
        const Block block = blocks[k];
        sums[static_cast<std::size_t>(k)] = sum_in_chains<T>(block.first, block.first + block.count, map);
    });
    return sums;
}

/// Returns the part of this holder in a sum over all entities; map is called for ghosts too.
template <class Map>
Total<SumOf<Map>> part_of_sum(const Blocks& blocks, const Map& map) {
    const auto sums = sums_of_blocks(blocks, map);
    Total<SumOf<Map>> total;
    for (std::int64_t k = 0; k < blocks.count(); ++k) {
        if (blocks[k].own) {
            total.add(sums[static_cast<std::size_t>(k)]);
        }
    }
    return total;
}

/// Returns the sum over the own entities of this holder. For all entities it has the bits of parallel::sum.
template <class Map>
SumOf<Map> sum(const Blocks& blocks, const Map& map) {
    return blocks.are_all() ? sum(blocks.size(), map) : part_of_sum(blocks, map).value();
}

/// Folds map(i) over the own entities of this holder, for a fold whose result has no order: a largest, a first.
template <class T, class Map, class Fold>
T reduce(const Blocks& blocks, const T& identity, const Map& map, const Fold& fold) {
    if (blocks.are_all()) {
        return reduce(blocks.size(), identity, map, fold);
    }
    std::vector<T> partial(static_cast<std::size_t>(blocks.count()), identity);
    for_each_uneven(blocks.count(), 1, [&](std::int64_t k) {
        const Block block = blocks[k];
        T result = identity;
        for (std::int64_t i = block.first; i < block.first + block.count; ++i) {
            result = fold(result, map(i));
        }
        partial[static_cast<std::size_t>(k)] = result;
    });
    T total = identity;
    for (std::int64_t k = 0; k < blocks.count(); ++k) {
        total = blocks[k].own ? fold(total, partial[static_cast<std::size_t>(k)]) : total;
    }
    return total;
}

}  // namespace riprap::parallel
