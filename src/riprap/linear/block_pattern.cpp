// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/block_pattern.hpp"

#include <algorithm>

#include "riprap/core/parallel.hpp"

namespace riprap::linear {

std::int64_t BlockPattern::find(std::int64_t row, std::int64_t wanted) const {
    const auto low = column.begin() + first(row), high = column.begin() + end(row);
    const auto place = std::lower_bound(low, high, wanted);
    return place != high && *place == wanted ? place - column.begin() : -1;
}

BlockPattern symmetric_pattern(std::int64_t rows, std::span<const std::array<std::int32_t, 2>> pairs) {
    const auto count = static_cast<std::size_t>(rows);
    // with repeated columns at first
    std::vector<std::int64_t> start(count + 1, 0);
    for (std::size_t row = 0; row < count; ++row) {
        start[row] = 1;
    }
    for (const auto& [i, j] : pairs) {
        ++start[static_cast<std::size_t>(i)];
        ++start[static_cast<std::size_t>(j)];
    }
    parallel::exclusive_scan<std::int64_t>(start, start);
    std::vector<std::int32_t> column(static_cast<std::size_t>(start[count]));
    std::vector<std::int64_t> next(start.begin(), start.end() - 1);
    const auto add = [&](std::int32_t row, std::int32_t to) {
        column[static_cast<std::size_t>(next[static_cast<std::size_t>(row)]++)] = to;
    };
    for (std::size_t row = 0; row < count; ++row) {
        add(static_cast<std::int32_t>(row), static_cast<std::int32_t>(row));
    }
    for (const auto& [i, j] : pairs) {
        add(i, j);
        add(j, i);
    }
    BlockPattern pattern;
    pattern.start.assign(count + 1, 0);
    parallel::for_each_uneven(rows, 256, [&](std::int64_t row) {
        const auto low = column.begin() + start[static_cast<std::size_t>(row)];
        const auto high = column.begin() + start[static_cast<std::size_t>(row) + 1];
        std::sort(low, high);
        pattern.start[static_cast<std::size_t>(row)] = std::unique(low, high) - low;
    });
    parallel::exclusive_scan<std::int64_t>(pattern.start, pattern.start);
    pattern.column.resize(static_cast<std::size_t>(pattern.start[count]));
    parallel::for_each_uneven(rows, 256, [&](std::int64_t row) {
        std::copy_n(column.begin() + start[static_cast<std::size_t>(row)], pattern.end(row) - pattern.first(row),
                    pattern.column.begin() + pattern.first(row));
    });
    return pattern;
}

}  // namespace riprap::linear
