// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {

/// The largest `courant` at which no plane wave of sound grows on the lattice that the water starts from [-]:
///
///     w^2 + 2 l + 2 r - l r <= 4    and    l <= 2,    C = c_0 dt/h,
///     w = c_0 dt g,    l = 2 delta h c_0 dt L,    r = a h c_0 dt g^2,
///
/// g and L as in docs/theory/sph.md, 8; a is `acoustic_damping` where gradients are corrected, else 0. Over wave
/// numbers along the sides, the diagonals of faces and that of the cell, where the worst ones lie. For delta_sph;
/// viscosity is not in it.
double courant_bound(const SphSettings& settings);

}  // namespace riprap::fluid
