// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/chosen.hpp"
#include "riprap/fluid/sph/viscosity/artificial.hpp"
#include "riprap/fluid/sph/viscosity/laminar_sps.hpp"

namespace riprap::fluid {

/// The viscosities of SPH: one line registers a viscosity. Beside its word and keys (core/chosen.hpp) it has
///
/// - `double kinematic(settings, strain_rate)`: nu [m^2/s], which bounds the step and goes into the pairs as
///   mu = rho_0 nu, and `follows_strain`: whether nu depends on the strain rate;
/// - `bool follows_roughness()`: whether pairs get the roughness R in place of mu (roughness.hpp, delta_sph);
/// - `Pair pair(settings, kernel)`: one for each kernel that the pressure may have, `WendlandC2` (delta_sph) and
///   `SpikyKernel` (Müller's scheme).
///
/// Pair::add<Dim>(v, d, r2, r, F, V, mu_pair, force) writes the viscous force of one pair per V_i [N/m^3], with
/// d = x_i - x_j [m], v = v_i - v_j [m/s], F = (dW/dr)/r, the volume V of the neighbour and mu_pair = mu_i + mu_j
/// [Pa s]. Times V_i, it changes sign when i and j are swapped, so momentum is kept; force.v <= 0, so it only takes
/// energy. `has_transposed_stress`: whether it gets that half of the stress too, which is no sum over pairs
/// (transposed_stress.hpp).
using Viscosities = Chosen<  //
    ArtificialViscosity,     //
    LaminarSps               //
    >;

}  // namespace riprap::fluid
