// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/core/quat.hpp"
#include "riprap/core/sym3.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::coupling {

/// State of a fluid on a grid: water, and where bodies were when they were last cut out of the cells.
struct GridFluidFields {
    fluid::grid::GridState water;
    std::vector<Vec3> cut_position;     ///< of the bodies [m]
    std::vector<Quat> cut_orientation;  ///< body -> world
    std::vector<Sym3> cut_stretch;      ///< empty in scenes of rigid bodies

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        fluid::grid::GridState::visit_fields(self.water, visit);
        visit("grid.cut_position", self.cut_position);
        visit("grid.cut_orientation", self.cut_orientation);
        visit("grid.cut_stretch", self.cut_stretch);
    }
};

}  // namespace riprap::coupling
