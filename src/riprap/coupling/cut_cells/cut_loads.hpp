// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/coupling/cut_cells/cut_bodies.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::coupling {

/// Force [N] and torque about the centre of mass [N m] of the fluid on a body, apart by cause.
struct GridLoad {
    Vec3 pressure{}, shear{};
    Vec3 torque{};

    Vec3 force() const { return pressure + shear; }
};

/// Loads on bodies: -(P + rho g.x) times the vector area of each facet, with P of its cell and g.x at its centroid, so
/// that still water lifts with exactly rho g V; and the shear that the momentum equation took at faces near the body,
/// with the opposite sign.
std::vector<GridLoad> cut_loads(const fluid::grid::GridSettings& settings, const fluid::grid::GridState& state,
                                const fluid::grid::GridScratch& scratch, const std::vector<GridBody>& bodies,
                                const CutBodies& cut);

}  // namespace riprap::coupling
