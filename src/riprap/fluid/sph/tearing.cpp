// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/tearing.hpp"

#include <algorithm>

namespace riprap::fluid {

double density_by_tearing(double bareness, double density, double rest_density) {
    return bareness > 0 ? std::max(0.0, (1 - largest_stretch / bareness) * rest_density - density) : 0;
}

}  // namespace riprap::fluid
