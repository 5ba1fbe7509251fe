// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/material/material_set.hpp"

// Coefficients of restitution as shares of critical damping.

namespace riprap::solid::affine {

/// Returns the coefficient of restitution e of a mass on a spring with a share z of critical damping, whose contact
/// ends where spring and dashpot together would pull [SchwagerPoeschel2007]:
///
///     e = exp(-z/s (pi - asin(2 z s))), s = sqrt(1 - z^2), z^2 <= 1/2;   exp(-z/s asin(2 z s)), 1/2 < z^2 < 1;
///     e = exp(-z/s ln((z + s)/(z - s))), s = sqrt(z^2 - 1), z > 1.
double restitution_of(double damping_ratio);

/// Returns the share of critical damping that gives a coefficient of restitution: the inverse of restitution_of.
double damping_ratio_of(double restitution);

/// Returns the share of critical damping of a pair of materials: by its coefficient of restitution where both materials
/// or the pair have one, else its damping_ratio. More than 0 where it was given as a restitution of 1: 0 stands for
/// damping that nobody asked for.
double damping_ratio_of(const material::MaterialSet& materials, MaterialId a, MaterialId b);

}  // namespace riprap::solid::affine
