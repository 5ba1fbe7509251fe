// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/coupling/cut_cells/cut_bodies.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::coupling {

/// Force [N], torque about the centre of mass [N m] and pull sum sym(f r^T) [N m] of the fluid on a body, by cause.
struct GridLoad {
    Vec3 pressure{}, shear{};
    Vec3 torque{};  ///< of both
    Vec3 shear_torque{};
    Sym3 pull{}, shear_pull{};  ///< of both; of shear

    Vec3 force() const { return pressure + shear; }
};

/// Loads on bodies: -(P + rho g.x) times the vector area of each facet, with P of its cell and g.x at its centroid, so
/// that still water lifts with exactly rho g V; and the shear that the momentum equation took at faces near the body,
/// with the opposite sign. Facets in joints feel the water nearest to them: uplift is that of an open joint.
/// @param time  of the pressure, for gravity that changes [s]
std::vector<GridLoad> cut_loads(const fluid::grid::GridSettings& settings, const fluid::grid::GridState& state,
                                const fluid::grid::GridScratch& scratch, const std::vector<GridBody>& bodies,
                                const CutBodies& cut, double time);
inline std::vector<GridLoad> cut_loads(const fluid::grid::GridSettings& settings, const fluid::grid::GridState& state,
                                       const fluid::grid::GridScratch& scratch, const std::vector<GridBody>& bodies,
                                       const CutBodies& cut) {
    return cut_loads(settings, state, scratch, bodies, cut, state.time);
}

}  // namespace riprap::coupling
