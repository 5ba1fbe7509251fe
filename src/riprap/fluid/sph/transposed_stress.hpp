// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/math.hpp"

namespace riprap::fluid {

// The half of the viscous stress that [Morris1997] leaves out: of mu (grad u + (grad u)^T) his pairs have mu grad u.
// Inside a fluid without divergence the rest has no force, but at a free surface and on a wall that turns it is half of
// the traction. With G_ab = du_a/dx_b = -sum_j V_j F (v_i - v_j)_a d_b, d = x_i - x_j, F = (dW/dr)/r,
//
//     tau_i = mu_i G_i^T,     force per V_i of j:  V_j (tau_i + tau_j) F d,     of a wall:  V_w 2 tau_i F d.
//
// Forces of a pair are opposite, so momentum is kept; rigid rotation feels nothing where neighbours are all around.
// With the pairs of LaminarSps it takes sum V mu (M G:G + G:G^T), 2 mu S:S inside and never negative where
// M <= 1 (docs/theory/sph.md, 5). A slippery wall is as no wall. G is of the particles as they are, with a wall's
// velocity mirrored; angular momentum is kept to the accuracy of G.

/// Rows of a 3 x 3 tensor; planar scenes use the first two numbers of the first two rows.
inline constexpr int tensor_numbers = 9;

/// sums[3 a + b] = G_ab [1/s]
struct VelocityGradient {
    static constexpr int target_fields = 4, candidate_fields = 4;  ///< v, V
    static constexpr int sums = tensor_numbers, back_sums = tensor_numbers;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* i, const Real* j, const Real* d, Real, Real r, Real* sum, Real* back) const {
        const Real slope = kernel.slope_over_r(r);
        for (int a = 0; a < Dim; ++a) {
            const Real rate = slope * (j[a] - i[a]);
            for (int b = 0; b < Dim; ++b) {
                sum[3 * a + b] = sum[3 * a + b] + j[3] * rate * d[b];
                back[3 * a + b] = back[3 * a + b] + i[3] * rate * d[b];
            }
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

/// The same of walls, with the mirrored velocity u_w.
struct VelocityGradientAtWalls {
    static constexpr int target_fields = 3;     ///< v
    static constexpr int candidate_fields = 5;  ///< u_w, V_w, grip
    static constexpr int sums = tensor_numbers;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real, Real r, Real* sum) const {
        const Real slope = kernel.slope_over_r(r) * candidate[3] * candidate[4];
        for (int a = 0; a < Dim; ++a) {
            for (int b = 0; b < Dim; ++b) {
                sum[3 * a + b] = sum[3 * a + b] + slope * (candidate[a] - target[a]) * d[b];
            }
        }
    }
};

/// out_a = sum_b tau_ab d_b
template <int Dim, class Real>
RIPRAP_HD void tensor_apply(const Real* tensor, const Real* d, Real* out) {
    for (int a = 0; a < Dim; ++a) {
        out[a] = tensor[3 * a] * d[0];
        for (int b = 1; b < Dim; ++b) {
            out[a] = out[a] + tensor[3 * a + b] * d[b];
        }
    }
}

/// sums[0..2] = sum V_j (tau_i + tau_j) F d [N/m^3], sums[3] = -sum V_j (that force . v), twice the heat [W/m^3]
struct TransposedStress {
    static constexpr int target_fields = 4 + tensor_numbers, candidate_fields = target_fields;  ///< v, V, tau
    static constexpr int sums = 4, back_sums = 4;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* i, const Real* j, const Real* d, Real, Real r, Real* sum, Real* back) const {
        const Real slope = kernel.slope_over_r(r);
        Real stress[tensor_numbers], force[3], heat(0);
        for (int k = 0; k < 3 * Dim; ++k) {
            stress[k] = i[4 + k] + j[4 + k];
        }
        tensor_apply<Dim>(stress, d, force);
        for (int a = 0; a < Dim; ++a) {
            force[a] = slope * force[a];
            heat = heat + force[a] * (i[a] - j[a]);
            sum[a] = sum[a] + j[3] * force[a];
            back[a] = back[a] - i[3] * force[a];
        }
        sum[3] = sum[3] - j[3] * heat;
        back[3] = back[3] - i[3] * heat;
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

/// sums[0..2] = sum V_w 2 tau_i F d [N/m^3], sums[3] = -sum V_w (that force . (v_i - v_w)) [W/m^3]
struct TransposedFromWalls {
    static constexpr int target_fields = 3 + tensor_numbers;  ///< v, tau
    static constexpr int candidate_fields = 5;                ///< v_w, V_w, grip
    static constexpr int sums = 4;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real, Real r, Real* sum) const {
        const Real slope = Real(2) * kernel.slope_over_r(r) * candidate[3] * candidate[4];
        Real force[3];
        tensor_apply<Dim>(target + 3, d, force);
        for (int a = 0; a < Dim; ++a) {
            sum[a] = sum[a] + slope * force[a];
            sum[3] = sum[3] - slope * force[a] * (target[a] - candidate[a]);
        }
    }
};

/// The opposite, per V_w: sums[0..2] = sum V_j 2 tau_j F d, d = x_w - x_j.
struct TransposedOnWalls {
    static constexpr int target_fields = 1;                      ///< grip
    static constexpr int candidate_fields = 1 + tensor_numbers;  ///< V, tau
    static constexpr int sums = 3;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real, Real r, Real* sum) const {
        const Real slope = Real(2) * kernel.slope_over_r(r) * candidate[0] * target[0];
        Real force[3];
        tensor_apply<Dim>(candidate + 1, d, force);
        for (int a = 0; a < Dim; ++a) {
            sum[a] = sum[a] + slope * force[a];
        }
    }
};

}  // namespace riprap::fluid
