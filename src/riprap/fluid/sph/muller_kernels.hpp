// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "riprap/fluid/particle/sweep/math.hpp"

namespace riprap::fluid {

// The three kernels of [Muller2003], which end at R = 2 h (their h is our R). All integrate to 1 in their dimension;
// docs/theory/sph.md, 9 has the two-dimensional forms.

/// (poly6) W = a (R^2 - r^2)^3, a = 315/(64 pi R^9), in 2D 4/(pi R^8): for density.
struct Poly6Kernel {
    double radius_squared{0}, peak{0};
    Poly6Kernel() = default;
    Poly6Kernel(double radius, int dimension) : radius_squared(radius * radius) {
        const double r8 = radius_squared * radius_squared * radius_squared * radius_squared;
        peak = dimension == 2 ? 4 / (std::numbers::pi * r8) : 315 / (64 * std::numbers::pi * r8 * radius);
    }
    template <class Real>
    RIPRAP_HD Real value_at(Real r2) const {
        const Real rest = max(Real(radius_squared) - r2, Real(0));
        return Real(peak) * rest * rest * rest;
    }
};

/// (spiky) W = b (R - r)^3, b = 15/(pi R^6), in 2D 10/(pi R^5): its slope, (dW/dr)/r = -3 b (R - r)^2/r, for pressure.
struct SpikyKernel {
    double radius{0}, slope_factor{0}, tiny{0};
    SpikyKernel() = default;
    SpikyKernel(double support_radius, int dimension) : radius(support_radius), tiny(1e-6 * support_radius) {
        const double r5 = radius * radius * radius * radius * radius;
        slope_factor = dimension == 2 ? -30 / (std::numbers::pi * r5) : -45 / (std::numbers::pi * r5 * radius);
    }
    /// Finite where a particle meets itself, where d = 0 makes the gradient zero.
    template <class Real>
    RIPRAP_HD Real slope_over_r(Real r) const {
        const Real rest = max(Real(radius) - r, Real(0));
        return Real(slope_factor) * rest * rest * reciprocal(r + Real(tiny));
    }
};

/// (viscosity) its Laplacian L = c (R - r), c = 45/(pi R^6); in 2D, where the kernel's own Laplacian is another, the
/// same shape with the second moment of a Laplacian, integral of L r^2 = 2 dimension: c = 40/(pi R^5).
struct LaplacianKernel {
    double radius{0}, factor{0};
    LaplacianKernel() = default;
    LaplacianKernel(double support_radius, int dimension) : radius(support_radius) {
        const double r5 = radius * radius * radius * radius * radius;
        factor = dimension == 2 ? 40 / (std::numbers::pi * r5) : 45 / (std::numbers::pi * r5 * radius);
    }
    template <class Real>
    RIPRAP_HD Real laplacian(Real r) const {
        return Real(factor) * max(Real(radius) - r, Real(0));
    }
};

}  // namespace riprap::fluid
