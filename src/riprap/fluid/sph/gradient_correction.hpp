// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "riprap/fluid/sph/symmetric.hpp"

namespace riprap::fluid {

struct SphScratchData;

/// A symmetric tensor in the order of symmetric.hpp.
using Symmetric = std::array<double, symmetric_numbers>;
inline constexpr Symmetric unit_tensor{1, 1, 0, 1, 0, 0};

/// How the gradients of one particle are corrected.
struct GradientCorrection {
    Symmetric tensor;  ///< B [-]
    double share;      ///< s, from 0, where B = I, to 1, where velocities linear in space have their exact divergence
};

/// c, how much of a particle is inside what its moments were summed over: 0 where tr M/D <= 0.95 or >= 1.15, 1 from
/// 1.00 to 1.05, linear between.
/// @param trace  tr M/D
double interior_share(double trace);

/// The correction of gradients [RandlesLibersky1996], [BonetLok1999] inside the water and its absence at the rim:
///
///     B = I + s (M^-1 - I),    s = c min(1, 1/|M^-1 - I|),    c = interior_share(tr M/D),
///
/// M the moments of Continuity [-], D the dimension, |.| the Frobenius norm (docs/theory/sph.md, 4); s = 0 where M is
/// singular, and B - I has its limit there.
/// @param dimension  2 or 3; in 2 only the first three numbers of a tensor count
GradientCorrection gradient_correction(int dimension, const Symmetric& moments);

/// B : G, the double contraction.
double contract(int dimension, const Symmetric& b, const Symmetric& g);

/// B = I for all particles.
void leave_gradients(std::size_t particles, SphScratchData& scratch);

}  // namespace riprap::fluid
