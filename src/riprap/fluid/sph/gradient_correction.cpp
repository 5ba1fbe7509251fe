// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/gradient_correction.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/sph/sph_scratch.hpp"

namespace riprap::fluid {
namespace {

constexpr Symmetric unit{1, 1, 0, 1, 0, 0};

/// M^-1 - I, or zero where M is close to singular
Symmetric excess_of_inverse(const Symmetric& m) {
    const auto [xx, yy, xy, zz, xz, yz] = m;
    const Symmetric cofactor{yy * zz - yz * yz, xx * zz - xz * xz, xz * yz - xy * zz,
                             xx * yy - xy * xy, xy * yz - yy * xz, xy * xz - xx * yz};
    const double determinant = xx * cofactor[0] + xy * cofactor[2] + xz * cofactor[4];
    Symmetric excess{};
    if (determinant > 1e-3) {
        for (std::size_t k = 0; k < excess.size(); ++k) {
            excess[k] = cofactor[k] / determinant - unit[k];
        }
    }
    return excess;
}

/// c, of tr M/D
double correctness(double trace) {
    // Behind a flat surface at h/dp = 1.5 the rows of a square (cubic) lattice have 0.62 (0.67), 0.91 (0.94), 1.00
    // (1.00); flowing water has 0.98 to 1.05 inside, and particles that are squeezed into a corner more than 1.15.
    constexpr double cut = 0.95, whole = 1.00, crowding = 1.05, crowded = 1.15;
    return std::clamp(std::min((trace - cut) / (whole - cut), (crowded - trace) / (crowded - crowding)), 0.0, 1.0);
}

}  // namespace

GradientCorrection gradient_correction(int dimension, const Symmetric& moments) {
    Symmetric m = moments;
    if (dimension == 2) {
        m[3] = 1;
        m[4] = m[5] = 0;
    }
    const double trace = m[0] + m[1] + (dimension == 2 ? 0 : m[3]);
    const Symmetric excess = excess_of_inverse(m);
    const double size = std::sqrt(contract(3, excess, excess));
    GradientCorrection correction{unit, correctness(trace / dimension) / std::max(1.0, size)};
    for (std::size_t k = 0; k < excess.size(); ++k) {
        correction.tensor[k] += correction.share * excess[k];
    }
    return correction;
}

double contract(int dimension, const Symmetric& b, const Symmetric& g) {
    const double planar = b[0] * g[0] + b[1] * g[1] + 2 * b[2] * g[2];
    return dimension == 2 ? planar : planar + b[3] * g[3] + 2 * (b[4] * g[4] + b[5] * g[5]);
}

void leave_gradients(std::size_t particles, SphScratchData& scratch) {
    scratch.correction.resize(particles);
    parallel::for_each(static_cast<std::int64_t>(particles),
                       [&](std::int64_t i) { scratch.correction[static_cast<std::size_t>(i)] = unit; });
}

}  // namespace riprap::fluid
