// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/contact/broadphase/broadphase.hpp"
#include "riprap/contact/broadphase/cell_order.hpp"
#include "riprap/contact/broadphase/giants.hpp"
#include "riprap/contact/broadphase/pair_sort.hpp"

namespace riprap::contact {

/// Finds candidate pairs in O(n * levels): a hierarchy of uniform grids, one
/// per size class, each with cells of twice the largest radius of its class
/// plus the skin. A part searches half of the 27 cells around it on its own
/// level and all 27 on every coarser level, never a finer one, so a large part
/// does not enumerate the many small ones around it. After the grouped grids of
/// [Zhao, eqs 37-40], with the cell size corrected (docs/theory/broadphase.md).
///
/// The object only holds buffers: the pairs depend on the arguments alone, and
/// are the same at any thread count.
class MultilevelGrid {
 public:
    /// Same pairs, in the same order, as find_pairs_brute_force.
    ///
    /// @param giants  parts kept out of the grid and tested by their planes; see
    /// choose_giants
    /// @param skin    s >= 0 [m]
    /// @param factor  gamma > 1, ratio of radii between size classes [-]
    /// @param pairs   receives the pairs; its memory is reused
    void find_pairs(const PartBounds& bounds, std::span<const Giant> giants, double skin, double factor,
                    std::vector<PartPair>& pairs);

    /// Bytes of the buffers, for the memory figures.
    std::size_t bytes() const;

 private:
    /// Work of one task: a run of occupied cells of one level against their
    /// own level, or a run of queries into coarser levels.
    struct Piece {
        std::size_t level, begin, end;
        bool is_query;
    };
    /// Copies of the entries in the 27 cells around a query's, side by side.
    struct Neighbourhood {
        std::vector<CellOrder::Entry> entry;
        std::vector<CellOrder::Owner> owner;
        std::size_t count{0};  ///< of them, the rest is room
        void append(const CellOrder& order, std::size_t begin, std::size_t end);
    };
    void cut_into_pieces();
    void search_own_level(const Piece& piece, double skin, PairList& found) const;
    void search_coarser_levels(const Piece& piece, double skin, Neighbourhood& around, PairList& found) const;
    void search_giants(const PartBounds& bounds, double skin, std::size_t block, PairList& found) const;

    CellOrder order_;
    GiantPlanes planes_;
    std::vector<std::uint8_t> is_apart_;  // giants, and what no mobile part can reach
    std::vector<Piece> pieces_;
    std::vector<PairList> found_;
    std::vector<Neighbourhood> around_;
    PairSorter sorter_;
};

}  // namespace riprap::contact
