// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/tearing.hpp"

#include <algorithm>
#include <cmath>

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

double caught_share(double alone, double moments) {
    constexpr double open = 0.65, enclosed = 0.8, narrow = 0.95, shut = 1.0;
    const double company = 0.05 + 0.2 * std::clamp((moments - narrow) / (shut - narrow), 0.0, 1.0);
    return std::max(0.0, 1 - alone / company) * std::clamp((moments - open) / (enclosed - open), 0.0, 1.0);
}

double density_by_escape(double caught, double density, double rest_density, double passed) {
    const double share = std::max(0.0, 2 * caught - 1);
    return share > 0 ? share * (rest_density - density) * (1 - std::exp(-passed)) : 0;
}

}  // namespace riprap::fluid
