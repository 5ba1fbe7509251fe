// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/contact/contact_set.hpp"

namespace riprap::contact {

/// Pairs found by one piece of a search, in any order. The memory is kept from search to search.
class PairList {
 public:
    void clear() { count_ = 0; }
    std::int64_t size() const { return static_cast<std::int64_t>(count_); }
    const PartPair* begin() const { return pairs_.data(); }
    const PartPair* end() const { return pairs_.data() + count_; }

    /// Room for `more` pairs, for loops that write first and decide after: write to the pointer, then `advance`.
    PartPair* reserve(std::size_t more) {
        if (pairs_.size() - count_ < more) {
            pairs_.resize(2 * pairs_.size() + more);
        }
        return pairs_.data() + count_;
    }
    void advance_to(const PartPair* end_of_pairs) { count_ = static_cast<std::size_t>(end_of_pairs - pairs_.data()); }
    void push(PartPair pair) {
        PartPair* const room = reserve(1);
        *room = pair;
        ++count_;
    }
    std::size_t bytes() const { return pairs_.capacity() * sizeof(PartPair); }

 private:
    std::vector<PartPair> pairs_;
    std::size_t count_{0};
};

/// Puts the pairs of many lists into one vector sorted by (a, b). All pairs differ, so the order has no ties and
/// does not depend on how the lists were cut. Linear in pairs and parts: pairs are dealt into ranges of `a`, then each
/// range is ordered by counting, and the few partners of each part by comparison.
class PairSorter {
 public:
    /// @param lists       the first `list_count` entries are read
    /// @param part_count  above every index in the pairs
    /// @param out         receives the pairs; its memory is reused
    void sort(const std::vector<PairList>& lists, std::size_t list_count, std::int32_t part_count,
              std::vector<PartPair>& out);
    std::size_t bytes() const {
        return (place_.capacity() + range_begin_.capacity() + row_end_.capacity()) * sizeof(std::uint64_t) +
               dealt_.capacity() * sizeof(PartPair);
    }

 private:
    void sort_range(std::size_t range, int shift, std::int32_t part_count, std::vector<PartPair>& out);

    std::vector<std::uint64_t> place_;        ///< list-major counts, then positions, of each range
    std::vector<std::uint64_t> range_begin_;  ///< first pair of each range of `a`
    std::vector<PartPair> dealt_;             ///< pairs grouped by range
    std::vector<std::uint64_t> row_end_;      ///< per part: running position in `out`
};

}  // namespace riprap::contact
