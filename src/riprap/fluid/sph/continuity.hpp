// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/math.hpp"

namespace riprap::fluid {

/// What neighbours in the fluid do to the density of particle i, with F = (dW/dr)/r, d = x_i - x_j, v = v_i - v_j:
///
///     sums[0] = sum V_j F v.d                         (1/rho) drho/dt: compression as the particles carry it
///     sums[1] = -sum V_j F (p_j - p_i + rho_0 g.d)    diffusion of the part of the pressure that is not hydrostatic
///     sums[2] = -sum V_j F (v.d)^2/r^2                times (dimension + 2): 2 S:S + (tr S)^2, S the strain rate
///     sums[3] = -sum V_j F r^2                        divergence of position: the dimension where full, less near
///                                                     the surface
///
/// sums[1] is the diffusion of [Fourtakas2019], of pressure instead of density: exactly nothing in still water under
/// any state equation, and no volume made or lost by a pair (docs/theory/sph.md, 4). sums[2] is derived there, 7.
struct Continuity {
    static constexpr int target_fields = 5;     ///< v, p, V
    static constexpr int candidate_fields = 5;  ///< the same
    static constexpr int sums = 4, back_sums = 4;
    WendlandC2 kernel;
    double weight[3];  ///< rho_0 g [N/m^3]
    double soft;       ///< small against h^2, keeps (v.d)^2/r^2 finite where a particle meets itself [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real r, Real* sum, Real* back) const {
        Real closing(0), head(0);
        for (int axis = 0; axis < Dim; ++axis) {
            closing = closing + (a[axis] - b[axis]) * d[axis];
            head = head + Real(weight[axis]) * d[axis];
        }
        const Real slope = kernel.slope_over_r(r), compression = slope * closing;
        const Real diffusion = slope * (b[3] - a[3] + head), filling = slope * r2;
        const Real strain = compression * closing * reciprocal(r2 + Real(soft));
        sum[0] = sum[0] + b[4] * compression;
        back[0] = back[0] + a[4] * compression;
        sum[1] = sum[1] - b[4] * diffusion;
        back[1] = back[1] + a[4] * diffusion;
        sum[2] = sum[2] - b[4] * strain;
        back[2] = back[2] - a[4] * strain;
        sum[3] = sum[3] - b[4] * filling;
        back[3] = back[3] - a[4] * filling;
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        Real back[back_sums] = {Real(0), Real(0), Real(0), Real(0)};
        exchange<Dim>(target, candidate, d, r2, r, sum, back);
    }
};

/// What walls do to it: sums[0] and sums[3] as above, here sums[0] and sums[1], with the wall's own velocity and
/// volume. No diffusion into walls.
struct ContinuityAtWalls {
    static constexpr int target_fields = 3;     ///< v
    static constexpr int candidate_fields = 4;  ///< v, V
    static constexpr int sums = 2;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        Real closing(0);
        for (int axis = 0; axis < Dim; ++axis) {
            closing = closing + (target[axis] - candidate[axis]) * d[axis];
        }
        const Real slope = candidate[3] * kernel.slope_over_r(r);
        sum[0] = sum[0] + slope * closing;
        sum[1] = sum[1] - slope * r2;
    }
};

}  // namespace riprap::fluid
