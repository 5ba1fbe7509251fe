// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/tearing.hpp"

#include <algorithm>

namespace riprap::fluid {

bool may_leave_walls(double bareness, double bareness_alone, double moments) {
    // Rows behind a flat surface have 0.62 (0.67 in 3D), 0.91 (0.94) and 1.00, whether walls stand beside them or not.
    constexpr double reach_of_air = 0.95;
    return bareness_alone > bareness && moments < reach_of_air;
}

double density_by_tearing(double bareness, bool leaves_wall, double density, double rest_density) {
    if (leaves_wall) {
        return std::max(0.0, rest_density - density);
    }
    return bareness > 0 ? std::max(0.0, (1 - largest_stretch / bareness) * rest_density - density) : 0;
}

}  // namespace riprap::fluid
