// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "riprap/fluid/sph/gradient_correction.hpp"

namespace riprap::fluid {

/// Share of artificial viscosity that a particle feels where smooth flow is spared: 0 where its neighbours move about
/// it as a velocity linear in space says, 1 where they move at random [-],
///
///     r = 1 - (2 G:G + (tr G)^2)/(m q),   R = clamp((r - 0.3)/0.4, 0, 1)   (docs/theory/sph.md, 5).
///
/// Sums over a square lattice are up to an eighth off, and disorder adds to that, so that r is 0.3 at most in smooth
/// flow; velocities at random have 0.7 and more.
/// @param rates   G of Continuity [1/s]
/// @param strain  q = (D + 2) sum V_j (-F) (v.d)^2/r^2: 2 S:S + (tr S)^2 in smooth flow [1/s^2]
/// @param trace   m = tr M/D, in proportion to which both miss what neighbours a surface cuts off [-]
RIPRAP_HD inline double roughness(int dimension, const Symmetric& rates, double strain, double trace_of_moments) {
    constexpr double smooth = 0.3, rough = 0.7;
    const double whole = trace_of_moments * strain;
    if (!(whole > 0)) {
        return 0;
    }
    const double divergence = trace(dimension, rates);
    const double linear = 2 * contract(dimension, rates, rates) + divergence * divergence;
    return std::clamp((1 - linear / whole - smooth) / (rough - smooth), 0.0, 1.0);
}

}  // namespace riprap::fluid
