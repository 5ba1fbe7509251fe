// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/shifting.hpp"

#include <algorithm>

namespace riprap::fluid {

double bareness_of_particle(int dimension, double divergence) {
    // Behind a flat surface at h/dp = 1.5 the rows of a square (cubic) lattice have divergence/dimension = 0.62 (0.67),
    // 0.91 (0.94), 1.00 (1.00).
    constexpr double bare = 0.70, covered = 0.85;
    return std::clamp((covered - divergence / dimension) / (covered - bare), 0.0, 1.0);
}

Vec3 shift_of_particle(const SphSettings& s, const Vec3& gradient, const Vec3& towards_surface, double bareness,
                       double strain, double dt) {
    const double h = s.smoothing_length();
    Vec3 shift = -(s.shifting * h * h * strain * dt * (1 - bareness)) * gradient;
    const double nearness = norm(towards_surface), outward = dot(shift, towards_surface);
    if (nearness > 0 && outward > 0) {
        // one bare particle a smoothing length away has h V |grad W| = 0.1 or more: then nothing is left of it
        const double share = std::min(1.0, h * nearness / 0.05);
        shift -= (share * outward / (nearness * nearness)) * towards_surface;
    }
    const double length = norm(shift), longest = 0.1 * s.spacing;
    return length > longest ? (longest / length) * shift : shift;
}

}  // namespace riprap::fluid
