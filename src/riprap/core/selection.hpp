// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "riprap/core/parallel.hpp"

namespace riprap::parallel {

namespace detail {
void note_selected(std::size_t count);
}  // namespace detail

/// Entries that selections have handed out since the program began, of all threads [-]. Tests hold it against the
/// number of particles: what looks at the water one particle by another asks for the few that matter.
std::int64_t entries_selected();

/// The numbers i in [0, n) with is(i), ascending: the few that the host looks at one by one, in the one order of all.
/// `is` is asked on all threads and must not depend on what was asked before, so that the result doesn't either.
template <class Is>
std::vector<std::size_t> select(std::int64_t n, const Is& is) {
    const std::int64_t block_count = (n + reduce_block - 1) / reduce_block;
    std::vector<std::vector<std::size_t>> found(static_cast<std::size_t>(block_count));
    for_ranges(n, reduce_block, [&](std::int64_t begin, std::int64_t end) {
        std::vector<std::size_t>& here = found[static_cast<std::size_t>(begin / reduce_block)];
        for (std::int64_t i = begin; i < end; ++i) {
            if (is(static_cast<std::size_t>(i))) {
                here.push_back(static_cast<std::size_t>(i));
            }
        }
    });
    std::vector<std::size_t> all;
    for (const std::vector<std::size_t>& here : found) {
        all.insert(all.end(), here.begin(), here.end());
    }
    detail::note_selected(all.size());
    return all;
}

}  // namespace riprap::parallel
