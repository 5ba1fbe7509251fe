// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/math.hpp"
#include "riprap/fluid/sph/muller_kernels.hpp"

namespace riprap::fluid {

// Viscous force of one pair per V_i, written to `force` [N/m^3], with d = x_i - x_j [m], v = v_i - v_j [m/s], F =
// (dW/dr)/r, the volume V of the neighbour and mu_pair = mu_i + mu_j [Pa s]. Times V_i, all change sign when i and j
// are swapped, so momentum is kept, and force.v <= 0, so they only take energy.

/// [Monaghan1992], with the rest density and sound speed of [Antuono2010]: particles that approach repel,
///
///     force = V alpha h c_0 rho_0 min(0, v.d)/(r^2 + 0.01 h^2) F d.
struct ArtificialViscosity {
    double strength;  ///< alpha h c_0 rho_0 [Pa s]
    double soft;      ///< 0.01 h^2 [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void add(const Real* v, const Real* d, Real r2, Real, Real slope, Real volume, Real, Real* force) const {
        Real closing(0);
        for (int axis = 0; axis < Dim; ++axis) {
            closing = closing + v[axis] * d[axis];
        }
        const Real size = Real(strength) * min(closing, Real(0)) * reciprocal(r2 + Real(soft)) * slope * volume;
        for (int axis = 0; axis < Dim; ++axis) {
            force[axis] = size * d[axis];
        }
    }
};

/// Laminar viscosity [Morris1997], molecular plus that of the eddies which the spacing does not resolve:
///
///     force = V (mu_i + mu_j) F v.
struct LaminarViscosity {
    template <int Dim, class Real>
    RIPRAP_HD void add(const Real* v, const Real*, Real, Real, Real slope, Real volume, Real mu_pair,
                       Real* force) const {
        for (int axis = 0; axis < Dim; ++axis) {
            force[axis] = mu_pair * slope * volume * v[axis];
        }
    }
};

/// Laminar viscosity of [Muller2003], its sign corrected:
///
///     force = -V (mu_i + mu_j)/2 L v.
struct MullerViscosity {
    LaplacianKernel kernel;

    template <int Dim, class Real>
    RIPRAP_HD void add(const Real* v, const Real*, Real, Real r, Real, Real volume, Real mu_pair, Real* force) const {
        const Real size = Real(-0.5) * mu_pair * kernel.laplacian(r) * volume;
        for (int axis = 0; axis < Dim; ++axis) {
            force[axis] = size * v[axis];
        }
    }
};

}  // namespace riprap::fluid
