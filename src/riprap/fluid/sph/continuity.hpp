// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/sweep/math.hpp"
#include "riprap/fluid/particle/sweep/symmetric.hpp"

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
    enum Field : int { velocity, pressure = velocity + 3, volume, field_count };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    // Places of the sums.
    static constexpr int at_diffusion = 0, at_strain_rate = 1, at_moments = 2,
                         at_rates = at_moments + symmetric_numbers, at_concentration = at_rates + symmetric_numbers;
    static constexpr int sums = at_concentration + 3, back_sums = sums;
    WendlandC2 kernel;
    double weight[3];  ///< rho_0 g [N/m^3]
    double soft;       ///< small against h^2, keeps (v.d)^2/r^2 finite where a particle meets itself [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real r, Real* sum, Real* back) const {
        Real v[3], moment[symmetric_numbers], change[symmetric_numbers];
        Real closing(0), head(0);
        for (int axis = 0; axis < Dim; ++axis) {
            v[axis] = a[velocity + axis] - b[velocity + axis];
            closing = closing + v[axis] * d[axis];
            head = head + Real(weight[axis]) * d[axis];
        }
        const Real slope = kernel.slope_over_r(r), slope_a = a[volume] * slope, slope_b = b[volume] * slope;
        const Real uneven = b[pressure] - a[pressure] + head, strain = closing * closing * reciprocal(r2 + Real(soft));
        sum[at_diffusion] = sum[at_diffusion] - slope_b * uneven;
        back[at_diffusion] = back[at_diffusion] + slope_a * uneven;
        sum[at_strain_rate] = sum[at_strain_rate] - slope_b * strain;
        back[at_strain_rate] = back[at_strain_rate] - slope_a * strain;
        symmetric_square<Dim>(d, moment);
        symmetric_product<Dim>(d, v, change);
        for (int k = 0; k < symmetric_used<Dim>; ++k) {
            sum[at_moments + k] = sum[at_moments + k] - slope_b * moment[k];
            back[at_moments + k] = back[at_moments + k] - slope_a * moment[k];
            sum[at_rates + k] = sum[at_rates + k] + slope_b * change[k];
            back[at_rates + k] = back[at_rates + k] + slope_a * change[k];
        }
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_concentration + axis] = sum[at_concentration + axis] + slope_b * d[axis];
            back[at_concentration + axis] = back[at_concentration + axis] - slope_a * d[axis];
        }
    }
};

/// Sums over walls likewise: M, G and the gradient of concentration as above, with the wall's own velocity and volume.
/// No diffusion into walls.
struct ContinuityAtWalls {
    struct Water {
        enum : int { velocity, count = velocity + 3 };
    };
    struct Wall {
        enum : int { velocity, volume = velocity + 3, count };
    };
    static constexpr int target_fields = Water::count, candidate_fields = Wall::count;
    // Places of the sums.
    static constexpr int at_moments = 0, at_rates = symmetric_numbers, at_concentration = 2 * symmetric_numbers;
    static constexpr int sums = at_concentration + 3;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* water, const Real* wall, const Real* d, Real, Real r, Real* sum) const {
        Real v[3], moment[symmetric_numbers], change[symmetric_numbers];
        for (int axis = 0; axis < Dim; ++axis) {
            v[axis] = water[Water::velocity + axis] - wall[Wall::velocity + axis];
        }
        const Real slope = wall[Wall::volume] * kernel.slope_over_r(r);
        symmetric_square<Dim>(d, moment);
        symmetric_product<Dim>(d, v, change);
        for (int k = 0; k < symmetric_used<Dim>; ++k) {
            sum[at_moments + k] = sum[at_moments + k] - slope * moment[k];
            sum[at_rates + k] = sum[at_rates + k] + slope * change[k];
        }
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_concentration + axis] = sum[at_concentration + axis] + slope * d[axis];
        }
    }
};

}  // namespace riprap::fluid
