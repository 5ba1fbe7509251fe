// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "riprap/contact/broadphase/broadphase.hpp"

namespace riprap::contact {

/// Candidate pairs with one uniform grid for all sizes, in the manner of no-binary-search detection [Munjiza1998]:
/// cells of twice the largest radius plus the skin, parts of a cell in a linked list, each cell searched against
/// itself and half of its neighbours. Linear in n, but every cell of a large part may hold very many small ones: kept
/// as the comparison for MultilevelGrid, serial and without giants (all radii finite).
class SingleGrid {
 public:
    /// Same pairs, in the same order, as find_pairs_brute_force without giants.
    void find_pairs(const PartBounds& bounds, double skin, std::vector<PartPair>& pairs);

 private:
    void fill(const PartBounds& bounds, double skin);

    std::array<std::int32_t, 3> cell_count_{};
    std::vector<std::int32_t> head_;  ///< first part of each cell, -1 = none
    std::vector<std::int32_t> next_;  ///< next part of the same cell, -1 = none
};

}  // namespace riprap::contact
