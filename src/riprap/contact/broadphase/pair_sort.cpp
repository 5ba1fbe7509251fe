// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/broadphase/pair_sort.hpp"

#include <algorithm>

#include "riprap/core/parallel.hpp"

namespace riprap::contact {

namespace {

/// Ranges of `a` hold 2^shift parts: at least 1024, and few enough ranges that dealing writes stay in cache.
int choose_shift(std::int32_t part_count) {
    int shift = 10;
    while ((part_count >> shift) >= 256) {
        ++shift;
    }
    return shift;
}

void order_partners(PartPair* begin, PartPair* end) {
    if (end - begin > 32) {
        std::sort(begin, end);
        return;
    }
    for (PartPair* i = begin == end ? end : begin + 1; i < end; ++i) {
        const PartPair pair = *i;
        PartPair* j = i;
        for (; j > begin && pair.b < (j - 1)->b; --j) {
            *j = *(j - 1);
        }
        *j = pair;
    }
}

}  // namespace

void PairSorter::sort(const std::vector<PairList>& lists, std::size_t list_count, std::int32_t part_count,
                      std::vector<PartPair>& out) {
    const int shift = choose_shift(part_count);
    const std::size_t range_count = static_cast<std::size_t>(part_count >> shift) + 1;
    place_.assign(list_count * range_count, 0);
    parallel::for_each_uneven(static_cast<std::int64_t>(list_count), 4, [&](std::int64_t list) {
        std::uint64_t* const count = place_.data() + static_cast<std::size_t>(list) * range_count;
        for (const PartPair& pair : lists[static_cast<std::size_t>(list)]) {
            ++count[pair.a >> shift];
        }
    });
    range_begin_.resize(range_count + 1);
    std::uint64_t total = 0;
    for (std::size_t range = 0; range < range_count; ++range) {
        range_begin_[range] = total;
        for (std::size_t list = 0; list < list_count; ++list) {
            const std::uint64_t next = total + place_[list * range_count + range];
            place_[list * range_count + range] = total;
            total = next;
        }
    }
    range_begin_[range_count] = total;

    dealt_.resize(total);
    out.resize(total);
    row_end_.resize(static_cast<std::size_t>(part_count));
    parallel::for_each_uneven(static_cast<std::int64_t>(list_count), 4, [&](std::int64_t list) {
        std::uint64_t* const place = place_.data() + static_cast<std::size_t>(list) * range_count;
        for (const PartPair& pair : lists[static_cast<std::size_t>(list)]) {
            dealt_[place[pair.a >> shift]++] = pair;
        }
    });
    parallel::for_each_uneven(static_cast<std::int64_t>(range_count), 1, [&](std::int64_t range) {
        sort_range(static_cast<std::size_t>(range), shift, part_count, out);
    });
}

void PairSorter::sort_range(std::size_t range, int shift, std::int32_t part_count, std::vector<PartPair>& out) {
    const auto first_part = static_cast<std::size_t>(range << shift);
    const std::size_t last_part = std::min(static_cast<std::size_t>(part_count), (range + 1) << shift);
    std::fill(row_end_.begin() + static_cast<std::ptrdiff_t>(first_part),
              row_end_.begin() + static_cast<std::ptrdiff_t>(last_part), 0);
    for (std::uint64_t k = range_begin_[range]; k < range_begin_[range + 1]; ++k) {
        ++row_end_[static_cast<std::size_t>(dealt_[k].a)];
    }
    std::uint64_t next = range_begin_[range];
    for (std::size_t part = first_part; part < last_part; ++part) {
        const std::uint64_t count = row_end_[part];
        row_end_[part] = next;
        next += count;
    }
    for (std::uint64_t k = range_begin_[range]; k < range_begin_[range + 1]; ++k) {
        out[row_end_[static_cast<std::size_t>(dealt_[k].a)]++] = dealt_[k];
    }
    std::uint64_t begin = range_begin_[range];
    for (std::size_t part = first_part; part < last_part; ++part) {
        order_partners(out.data() + begin, out.data() + row_end_[part]);
        begin = row_end_[part];
    }
}

}  // namespace riprap::contact
