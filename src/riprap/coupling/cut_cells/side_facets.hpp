// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/coupling/cut_cells/cut_bodies.hpp"

namespace riprap::coupling {

/// CutFacet::joint of a facet on a side of the domain whose cell is open. A body that lies on a side, or reaches
/// through it by less than half a cell, has a joint with it: the facet bears the pressure of its cell, and moves no
/// fluid.
inline constexpr std::int32_t on_side = -2;

/// CutFacet::joint of a facet on the closed side of a wall thinner than a cell: the surface of its cell lies elsewhere,
/// but the facet moves its fluid.
inline constexpr std::int32_t behind_wall = -3;

inline bool moves_fluid(const CutFacet& facet) { return facet.joint != on_side; }
/// Tells whether what is open in the facet's cell ends at it.
inline bool bounds_cell(const CutFacet& facet) { return moves_fluid(facet) && facet.joint != behind_wall; }

}  // namespace riprap::coupling
