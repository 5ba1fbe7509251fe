// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/bytes.hpp"

namespace riprap::linear {

/// Places of the blocks of a square matrix, row by row: compressed sparse rows.
struct BlockPattern {
    std::vector<std::int64_t> start{0};  ///< first entry of each row, one more at the end
    std::vector<std::int32_t> column;    ///< of each entry, ascending within a row

    std::int64_t rows() const { return static_cast<std::int64_t>(start.size()) - 1; }
    std::int64_t entries() const { return static_cast<std::int64_t>(column.size()); }
    std::int64_t first(std::int64_t row) const { return start[static_cast<std::size_t>(row)]; }
    std::int64_t end(std::int64_t row) const { return start[static_cast<std::size_t>(row) + 1]; }
    std::int32_t column_of(std::int64_t entry) const { return column[static_cast<std::size_t>(entry)]; }

    /// The entry at (row, column), -1 where there is none. Bisects the row.
    std::int64_t find(std::int64_t row, std::int64_t column) const;

    std::size_t bytes() const { return bytes_of(start, column); }
    friend bool operator==(const BlockPattern&, const BlockPattern&) = default;
};

/// Places of the diagonal and, for each pair {i, j}, of the blocks (i, j) and (j, i). Pairs may come in any order and
/// more than once.
BlockPattern symmetric_pattern(std::int64_t rows, std::span<const std::array<std::int32_t, 2>> pairs);

}  // namespace riprap::linear
