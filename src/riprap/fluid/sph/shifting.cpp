// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/shifting.hpp"

#include <algorithm>

namespace riprap::fluid {

Vec3 shift_of_particle(const SphSettings& s, const Vec3& gradient, double divergence, double strain, double dt) {
    // Behind a flat surface at h/dp = 1.5 the rows of a square (cubic) lattice have divergence/dimension = 0.62 (0.67),
    // 0.91 (0.94), 1.00 (1.00): the first two rows stay, the third moves freely.
    constexpr double at_surface = 0.94, inside = 0.98;
    const double fullness = divergence / s.domain.dimension;
    const double freedom = std::clamp((fullness - at_surface) / (inside - at_surface), 0.0, 1.0);
    const double h = s.smoothing_length();
    const Vec3 shift = -(s.shifting * h * h * strain * dt * freedom) * gradient;
    const double length = norm(shift), longest = 0.1 * s.spacing;
    return length > longest ? (longest / length) * shift : shift;
}

}  // namespace riprap::fluid
