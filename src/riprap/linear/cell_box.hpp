// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"

namespace riprap::linear {

/// A box of cells in flat arrays with `pad` layers around it along the axes in use; a plane is a box with two of them.
/// Rows run along the first axis. A face array has the same layout: entry i is the face between cell i and the cell
/// below it.
struct CellBox {
    std::array<int, 3> cells{1, 1, 1};            ///< along each axis [-]
    std::array<int, 3> pad{0, 0, 0};              ///< layers on either side [-]
    std::array<std::int64_t, 3> stride{1, 1, 1};  ///< between neighbours in a flat array [-]
    std::int64_t size{1};                         ///< of a flat array [-]
    int axes{0};                                  ///< axes in use: 2 or 3

    CellBox() = default;
    /// A box with two axes in use has one cell along the third.
    CellBox(const std::array<int, 3>& count, int layers, int used_axes) : cells(count), axes(used_axes) {
        for (int a = 0; a < 3; ++a) {
            const auto k = static_cast<std::size_t>(a);
            pad[k] = a < axes ? layers : 0;
            stride[k] = size;
            size *= cells[k] + 2 * pad[k];
        }
    }
    bool has_axis(int a) const { return a < axes; }
    std::int64_t index(int i, int j, int k) const {
        return (i + pad[0]) + stride[1] * (j + pad[1]) + stride[2] * (k + pad[2]);
    }
    /// Tells whether a flat index is that of a cell, not of a ghost.
    bool has_cell(std::int64_t cell) const {
        for (std::size_t a = static_cast<std::size_t>(axes); a-- > 0;) {
            const std::int64_t p = cell / stride[a] - pad[a];
            if (p < 0 || p >= cells[a]) {
                return false;
            }
            cell %= stride[a];
        }
        return true;
    }
    std::int64_t row_count() const { return static_cast<std::int64_t>(cells[1]) * cells[2]; }
    std::int64_t cell_count() const { return row_count() * cells[0]; }
    /// Returns the flat index of the first cell of a row.
    std::int64_t row_start(std::int64_t row) const {
        return index(0, static_cast<int>(row % cells[1]), static_cast<int>(row / cells[1]));
    }
    /// Returns the rows that one thread takes at a time: about 4096 cells, less is not worth waking a thread for.
    std::int64_t row_grain() const { return std::max<std::int64_t>(1, 4096 / cells[0]); }
};

/// Calls f(start, row) for every row of cells.
template <class F>
void for_rows(const CellBox& box, const F& f) {
    parallel::for_ranges(box.row_count(), box.row_grain(), [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t row = begin; row < end; ++row) {
            f(box.row_start(row), row);
        }
    });
}

/// Folds f(start, row) over all rows, for a fold whose result has no order: a largest, a count.
template <class T, class F, class Fold>
T reduce_rows(const CellBox& box, const T& identity, const F& f, const Fold& fold) {
    return parallel::reduce(
        box.row_count(), identity, [&](std::int64_t row) { return f(box.row_start(row), row); }, fold, box.row_grain());
}

/// Adds up f(start, row) over all rows: in order within blocks of row_grain() rows, and blocks exactly.
template <class F>
auto sum_rows(const CellBox& box, const F& f) {
    return parallel::sum(
        box.row_count(), [&](std::int64_t row) { return f(box.row_start(row), row); }, box.row_grain());
}

}  // namespace riprap::linear
