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

/// How much of a particle has neighbours evenly on all sides: 1 up to 0.2, where all but one in a thousand of those
/// inside flowing water are, 0 from 0.4 on, linear between; a flat surface has 0.6 or more. In a splash particles of
/// the surface may be so crowded that tr M/D is that of the inside: this tells them apart.
/// @param lopsidedness  h |sum V_j grad W| [-]
double even_share(double lopsidedness);

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
