// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "riprap/coupling/cut_cells/cut_bodies.hpp"

namespace riprap::coupling {

/// Closed shares of the faces below cells along x, y and z, by what bodies fill of the cells on their two sides [-].
struct ClosedShares {
    const std::array<std::vector<double>, 3>&below, &above;
};

/// Finds the water for closed cells with facets: from the nearest open cells, through closed cells beside them. Sets
/// CutBodies::joints and CutFacet::joint.
///
/// Takes a way through the body that a facet looks at, the other one of its joint, only where there is no other:
/// through a plate two cells thick it would lead to the water or air under it.
void find_joint_ways(const fluid::grid::Mesh& mesh, const ClosedShares& closed, CutBodies& cut);

}  // namespace riprap::coupling
