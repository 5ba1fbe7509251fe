// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "riprap/fluid/particle/sweep/symmetric.hpp"

namespace riprap::fluid {

/// A symmetric tensor in the order of symmetric.hpp.
using Symmetric = std::array<double, symmetric_numbers>;
RIPRAP_HD constexpr Symmetric make_unit_tensor() { return {1, 1, 0, 1, 0, 0}; }
inline constexpr Symmetric unit_tensor = make_unit_tensor();

/// tr M
RIPRAP_HD inline double trace(int dimension, const Symmetric& tensor) {
    return tensor[0] + tensor[1] + (dimension == 3 ? tensor[3] : 0);
}

/// B : G, the double contraction.
RIPRAP_HD inline double contract(int dimension, const Symmetric& b, const Symmetric& g) {
    const double planar = b[0] * g[0] + b[1] * g[1] + 2 * b[2] * g[2];
    return dimension == 2 ? planar : planar + b[3] * g[3] + 2 * (b[4] * g[4] + b[5] * g[5]);
}

/// Correction of the gradients of one particle.
struct GradientCorrection {
    Symmetric tensor;  ///< B [-]
    double share;      ///< s, from 0, where B = I, to 1, where velocities linear in space have their exact divergence
};

/// Returns c, the share of a particle that is inside what its moments were summed over: 0 where tr M/D <= 0.95 or
/// >= 1.15, 1 from 1.00 to 1.05, linear between.
/// @param trace  tr M/D
RIPRAP_HD inline double interior_share(double trace) {
    // Behind a flat surface at h/dp = 1.5 the rows of a square (cubic) lattice have 0.62 (0.67), 0.91 (0.94), 1.00
    // (1.00); flowing water has 0.98 to 1.05 inside, and particles that are squeezed into a corner more than 1.15.
    constexpr double cut = 0.95, whole = 1.00, crowding = 1.05, crowded = 1.15;
    return std::clamp(std::min((trace - cut) / (whole - cut), (crowded - trace) / (crowded - crowding)), 0.0, 1.0);
}

/// The correction of gradients [RandlesLibersky1996], [BonetLok1999] inside the water and its absence at the rim:
///
///     B = I + s (M^-1 - I),    s = c min(1, 1/|M^-1 - I|),    c = interior_share(tr M/D),
///
/// M the moments of Continuity [-], D the dimension, |.| the Frobenius norm (docs/theory/sph.md, 4); s = 0 where M is
/// singular, and B - I has its limit there.
/// @param dimension  2 or 3; in 2 only the first three numbers of a tensor count
RIPRAP_HD inline GradientCorrection gradient_correction(int dimension, const Symmetric& moments) {
    Symmetric m = moments;
    if (dimension == 2) {
        m[3] = 1;
        m[4] = m[5] = 0;
    }
    const auto [xx, yy, xy, zz, xz, yz] = m;
    Symmetric excess{yy * zz - yz * yz, xx * zz - xz * xz, xz * yz - xy * zz,
                     xx * yy - xy * xy, xy * yz - yy * xz, xy * xz - xx * yz};  // so far det M M^-1
    const Symmetric unit = make_unit_tensor();
    const double determinant = xx * excess[0] + xy * excess[2] + xz * excess[4];
    for (std::size_t k = 0; k < excess.size(); ++k) {
        excess[k] -= determinant * unit[k];
    }
    const double trace = xx + yy + (dimension == 2 ? 0 : zz), size = std::sqrt(contract(3, excess, excess));
    const double bound = std::max(determinant, size);
    GradientCorrection correction{unit, 0};
    if (bound > 0) {
        const double c = interior_share(trace / dimension);
        correction.share = c * std::max(determinant, 0.0) / bound;  // round-off may leave less than nothing
        for (std::size_t k = 0; k < excess.size(); ++k) {
            correction.tensor[k] += c / bound * excess[k];
        }
    }
    return correction;
}

}  // namespace riprap::fluid
