// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "riprap/core/vec3.hpp"
#include "riprap/linear/cell_box.hpp"

namespace riprap::fluid::grid {

using linear::CellBox;

inline std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Cartesian cells of any widths, with two layers of ghost cells as wide as those they mirror. A plane flow has two
/// axes in use and one cell along z. Velocities live on faces, everything else in cells (docs/theory/grid.md).
struct Mesh {
    CellBox box;
    std::array<std::vector<double>, 3> edge;      ///< places of the faces, cells + 1 along each axis [m]
    std::array<std::vector<double>, 3> width;     ///< of cells, ghosts included, first ghost first [m]
    std::array<std::vector<double>, 3> distance;  ///< from the centre below to that of the cell, as `width` [m]

    Mesh() = default;
    /// @param edges  increasing, two entries at least along each axis; a plane flow has exactly two along z [m]
    /// @param axes  in use, 2 or 3
    Mesh(const std::array<std::vector<double>, 3>& edges, int axes);

    static constexpr int ghosts = 2;
    double h(int a, int i) const { return width[at(a)][at(i + ghosts)]; }
    /// Distance between the centres of cells i - 1 and i [m].
    double d(int a, int i) const { return distance[at(a)][at(i + ghosts)]; }
    double centre(int a, int i) const;
    Vec3 centre(int i, int j, int k) const { return {centre(0, i), centre(1, j), centre(2, k)}; }
    double volume(int i, int j, int k) const { return h(0, i) * h(1, j) * h(2, k); }
    /// Area of a face across axis a of cell (i, j, k) [m^2].
    double face_area(int a, int i, int j, int k) const {
        return (a == 0 ? 1 : h(0, i)) * (a == 1 ? 1 : h(1, j)) * (a == 2 ? 1 : h(2, k));
    }
    /// Returns the cell along an axis that holds a place; the nearest one for a place outside.
    int cell_at(int a, double place) const;
    double smallest_width() const;
};

/// Places of n + 1 faces of equal cells from low to high [m].
std::vector<double> uniform_edges(double low, double high, int cells);

/// Calls f(index, i, j, k) for all cells with first <= (i, j, k) < last, rows shared out to threads.
template <class F>
void for_box(const CellBox& box, const std::array<int, 3>& first, const std::array<int, 3>& last, const F& f) {
    const int rows_y = last[1] - first[1], rows_z = last[2] - first[2];
    if (rows_y <= 0 || rows_z <= 0 || last[0] <= first[0]) {
        return;
    }
    parallel::for_ranges(static_cast<std::int64_t>(rows_y) * rows_z, box.row_grain(),
                         [&](std::int64_t begin, std::int64_t end) {
                             for (std::int64_t row = begin; row < end; ++row) {
                                 const int j = first[1] + static_cast<int>(row % rows_y);
                                 const int k = first[2] + static_cast<int>(row / rows_y);
                                 std::int64_t index = box.index(first[0], j, k);
                                 for (int i = first[0]; i < last[0]; ++i, ++index) {
                                     f(index, i, j, k);
                                 }
                             }
                         });
}
template <class F>
void for_cells(const CellBox& box, const F& f) {
    for_box(box, {0, 0, 0}, box.cells, f);
}
/// All faces across an axis, those on the rim included.
template <class F>
void for_faces(const CellBox& box, int a, const F& f) {
    std::array<int, 3> last = box.cells;
    last[at(a)] += 1;
    for_box(box, {0, 0, 0}, last, f);
}

/// Calls f(start, count, place) for every row of faces across an axis, those on the rim included.
template <class F>
void for_face_rows(const CellBox& box, int a, const F& f) {
    std::array<int, 3> last = box.cells;
    last[at(a)] += 1;
    parallel::for_ranges(static_cast<std::int64_t>(last[1]) * last[2], box.row_grain(),
                         [&](std::int64_t begin, std::int64_t end) {
                             for (std::int64_t row = begin; row < end; ++row) {
                                 const int j = static_cast<int>(row % last[1]), k = static_cast<int>(row / last[1]);
                                 f(box.index(0, j, k), last[0], std::array<int, 3>{0, j, k});
                             }
                         });
}

/// Folds f(index, i, j, k) over all cells, for a fold whose result has no order.
template <class T, class F, class Fold>
T reduce_cells(const CellBox& box, const T& identity, const F& f, const Fold& fold) {
    return linear::reduce_rows(
        box, identity,
        [&](std::int64_t start, std::int64_t row) {
            T sum = identity;
            const int j = static_cast<int>(row % box.cells[1]), k = static_cast<int>(row / box.cells[1]);
            for (int i = 0; i < box.cells[0]; ++i) {
                sum = fold(sum, f(start + i, i, j, k));
            }
            return sum;
        },
        fold);
}

/// Adds up f(index, i, j, k) over all cells, see linear::sum_rows.
template <class F>
auto sum_cells(const CellBox& box, const F& f) {
    return linear::sum_rows(box, [&](std::int64_t start, std::int64_t row) {
        using T = std::invoke_result_t<const F&, std::int64_t, int, int, int>;
        const parallel::JoinBy<parallel::AddRounded> by{};
        T sum{};
        const int j = static_cast<int>(row % box.cells[1]), k = static_cast<int>(row / box.cells[1]);
        for (int i = 0; i < box.cells[0]; ++i) {
            by.add(sum, f(start + i, i, j, k));
        }
        return sum;
    });
}

inline double max_of(double a, double b) { return a > b ? a : b; }

}  // namespace riprap::fluid::grid
