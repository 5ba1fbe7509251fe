// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/math.hpp"
#include "riprap/fluid/sph/symmetric.hpp"

namespace riprap::fluid {

/// Sums over neighbours in the fluid that change the density of particle i, and moments of their places, with F =
/// (dW/dr)/r,
/// d = x_i - x_j, v = v_i - v_j:
///
///     sums[0]     = -sum V_j F (p_j - p_i + rho_0 g.d)   diffusion of the part of the pressure that is not hydrostatic
///     sums[1]     = -sum V_j F (v.d)^2/r^2               times (dimension + 2): 2 S:S + (tr S)^2, S the strain rate
///     sums[2..7]  = M = -sum V_j F d d^T                 moments: the unit tensor where neighbours stand all around
///     sums[8..13] = G = sum V_j F (d v^T + v d^T)/2      B:G is (1/rho) drho/dt, B = M^-1 inside the water
///     sums[14..16] = sum V_j F d                        gradient of the concentration of particles [1/m]
///
/// sums[0] is the diffusion of [Fourtakas2019], of pressure instead of density: exactly nothing in still water under
/// any state equation, and no volume made or lost by a pair (docs/theory/sph.md, 4). sums[1] is derived there, 5. For
/// velocities linear in space, v = A d, G = -(M A^T + A M)/2, so that B:G = -tr A wherever the neighbours are.
struct Continuity {
    static constexpr int target_fields = 5;     ///< v, p, V
    static constexpr int candidate_fields = 5;  ///< the same
    static constexpr int sums = 5 + 2 * symmetric_numbers, back_sums = sums;
    WendlandC2 kernel;
    double weight[3];  ///< rho_0 g [N/m^3]
    double soft;       ///< small against h^2, keeps (v.d)^2/r^2 finite where a particle meets itself [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real r, Real* sum, Real* back) const {
        Real v[3], moment[symmetric_numbers], change[symmetric_numbers];
        Real closing(0), head(0);
        for (int axis = 0; axis < Dim; ++axis) {
            v[axis] = a[axis] - b[axis];
            closing = closing + v[axis] * d[axis];
            head = head + Real(weight[axis]) * d[axis];
        }
        const Real slope = kernel.slope_over_r(r), slope_a = a[4] * slope, slope_b = b[4] * slope;
        const Real uneven = b[3] - a[3] + head, strain = closing * closing * reciprocal(r2 + Real(soft));
        sum[0] = sum[0] - slope_b * uneven;
        back[0] = back[0] + slope_a * uneven;
        sum[1] = sum[1] - slope_b * strain;
        back[1] = back[1] - slope_a * strain;
        symmetric_product<Dim>(d, d, moment);
        symmetric_product<Dim>(d, v, change);
        for (int k = 0; k < symmetric_used<Dim>; ++k) {
            sum[2 + k] = sum[2 + k] - slope_b * moment[k];
            back[2 + k] = back[2 + k] - slope_a * moment[k];
            sum[8 + k] = sum[8 + k] + slope_b * change[k];
            back[8 + k] = back[8 + k] + slope_a * change[k];
        }
        for (int axis = 0; axis < Dim; ++axis) {
            sum[14 + axis] = sum[14 + axis] + slope_b * d[axis];
            back[14 + axis] = back[14 + axis] - slope_a * d[axis];
        }
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        Real back[back_sums];
        for (Real& number : back) {
            number = Real(0);
        }
        exchange<Dim>(target, candidate, d, r2, r, sum, back);
    }
};

/// Sums over walls likewise: M, G and the gradient of concentration as above, with the wall's own velocity and volume.
/// No diffusion into walls.
struct ContinuityAtWalls {
    static constexpr int target_fields = 3;     ///< v
    static constexpr int candidate_fields = 4;  ///< v, V
    static constexpr int sums = 2 * symmetric_numbers + 3;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real, Real r, Real* sum) const {
        Real v[3], moment[symmetric_numbers], change[symmetric_numbers];
        for (int axis = 0; axis < Dim; ++axis) {
            v[axis] = target[axis] - candidate[axis];
        }
        const Real slope = candidate[3] * kernel.slope_over_r(r);
        symmetric_product<Dim>(d, d, moment);
        symmetric_product<Dim>(d, v, change);
        for (int k = 0; k < symmetric_used<Dim>; ++k) {
            sum[k] = sum[k] - slope * moment[k];
            sum[symmetric_numbers + k] = sum[symmetric_numbers + k] + slope * change[k];
        }
        for (int axis = 0; axis < Dim; ++axis) {
            sum[2 * symmetric_numbers + axis] = sum[2 * symmetric_numbers + axis] + slope * d[axis];
        }
    }
};

}  // namespace riprap::fluid
