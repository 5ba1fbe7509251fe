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
    const double nearness = norm(towards_surface);
    if (nearness > 0) {
        // A bare particle a smoothing length away has h V |grad W| = 0.1 or more: then nothing is left. Gradients are
        // those of a cut support here and would not tell disorder from the surface.
        shift -= (dot(shift, towards_surface) / (nearness * nearness)) * towards_surface;
        shift *= 1 - std::min(1.0, h * nearness / 0.05);
    }
    // Bounds the length too: shifts go along -grad C or what is left of it, so that l^2 <= most A h^2 |S| dt/2, 0.05 dp
    // at A = 10 and |S| dt = 0.1.
    const double loss = dilution_by_shift(shift, gradient, 0);
    constexpr double most = 0.002;  // of the density in a step, which varies by about 1 % in all
    return (loss > most ? most / loss : 1.0) * shift;
}

double density_after_shift(double density, double dilution, double rest_density) {
    return std::max(std::min(density, rest_density), density * (1 - dilution));
}

double dilution_by_shift(const Vec3& shift, const Vec3& gradient, double corrected) {
    return -2 * (1 - corrected) * dot(shift, gradient);
}

}  // namespace riprap::fluid
