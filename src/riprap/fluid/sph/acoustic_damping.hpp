// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {

/// a, the strength of the damping of sound: `acoustic_damping` where gradients are corrected, else 0 [-].
double strength_of_damping(const SphSettings& settings);

/// e, how evenly the neighbours of a particle stand on all sides: 1 up to 0.2, 0 from 0.4 on, linear between
/// (docs/theory/sph.md, 5).
/// @param lopsidedness  h |sum_j V_j grad W(x_i - x_j)| over the water alone, V_j volumes [m^D], h the smoothing
///                      length [m] and W the kernel [1/m^D]: 0 on a lattice, 0.6 behind a flat surface at h/dp = 1.5
RIPRAP_HD inline double even_share(double lopsidedness) {
    // Inside waves that break 999 of 1000 particles have less than 0.2; first rows behind flat surfaces have 0.56 and
    // more from h/dp = 1.2 on, crowded ones more.
    constexpr double even = 0.2, lopsided = 0.4;
    return std::clamp((lopsided - lopsidedness) / (lopsided - even), 0.0, 1.0);
}

/// a h rho_0 c_0 [Pa s]. Forces see the pressure p + s_i a h rho_0 c_0 (-div v), which is that of a bulk viscosity, and
/// its heat per volume is s_i a h rho_0 c_0 (div v)^2 [Sun2023]; s_i is `damped_share` of the Scratch, -div v its
/// `compression_rate`.
double resistance_of_damping(const SphSettings& settings);

}  // namespace riprap::fluid
