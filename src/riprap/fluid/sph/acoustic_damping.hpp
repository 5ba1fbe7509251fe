// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {

struct SphScratchData;

/// a, the strength of the damping of sound: `acoustic_damping` where gradients are corrected, else 0 [-].
double strength_of_damping(const SphSettings& settings);

/// e, how evenly the neighbours of a particle stand on all sides: 1 up to 0.2, 0 from 0.4 on, linear between
/// (docs/theory/sph.md, 5).
/// @param lopsidedness  h |sum_j V_j grad W(x_i - x_j)| over the water alone, V_j volumes [m^D], h the smoothing
///                      length [m] and W the kernel [1/m^D]: 0 on a lattice, 0.6 behind a flat surface at h/dp = 1.5
double even_share(double lopsidedness);

/// Adds the bulk viscosity to the pressure that forces see, -a s_i h rho_0 c_0 div v, and notes its heat [Sun2023];
/// s_i is `damped_share`, -div v is `squeeze`.
void damp_sound(const SphSettings& settings, SphScratchData& scratch);

}  // namespace riprap::fluid
