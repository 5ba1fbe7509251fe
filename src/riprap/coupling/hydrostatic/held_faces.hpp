// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/coupling/hydrostatic/hydrostatic.hpp"

namespace riprap::coupling {

/// A piece of a face and the basin that wets it.
struct WetPiece {
    std::vector<Vec3> corner;  ///< world axes [m]
    const HydrostaticSettings::Basin* basin;
};

/// Returns the pieces of a convex face that stand in basins, cut at their sides and beds: floors and walls reach beyond
/// the water, unlike blocks in it. What lies in half-spaces is left out. A face on the side of a basin or of a
/// half-space, but for `slack`, is wet; a piece in two basins belongs to the first.
std::vector<WetPiece> wet_pieces(const FluidScene& scene, const HydrostaticSettings& settings,
                                 const body::Motion& motion, const std::vector<Vec3>& face, double slack);

}  // namespace riprap::coupling
