// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/surface_tension.hpp"

#include <cmath>

#include "riprap/fluid/grid/surface.hpp"

namespace riprap::fluid::grid {

void find_curvature(const GridSettings& settings, const GridState& state, GridScratch& s) {
    if (settings.surface_tension <= 0) {
        return;
    }
    (void)state;
    (void)s;
}

}  // namespace riprap::fluid::grid
