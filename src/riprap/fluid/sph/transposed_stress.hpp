// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/sweep/math.hpp"

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
    enum Field : int { velocity, volume = velocity + 3, field_count };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    static constexpr int sums = tensor_numbers, back_sums = tensor_numbers;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* i, const Real* j, const Real* d, Real, Real r, Real* sum, Real* back) const {
        const Real slope = kernel.slope_over_r(r);
        for (int a = 0; a < Dim; ++a) {
            const Real rate = slope * (j[velocity + a] - i[velocity + a]);
            for (int b = 0; b < Dim; ++b) {
                sum[3 * a + b] = sum[3 * a + b] + j[volume] * rate * d[b];
                back[3 * a + b] = back[3 * a + b] + i[volume] * rate * d[b];
            }
        }
    }
};

/// The same of walls, with the mirrored velocity u_w.
struct VelocityGradientAtWalls {
    struct Water {
        enum : int { velocity, count = velocity + 3 };
    };
    struct Wall {
        enum : int { mirrored_velocity, volume = mirrored_velocity + 3, grip, count };
    };
    static constexpr int target_fields = Water::count, candidate_fields = Wall::count;
    static constexpr int sums = tensor_numbers;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* water, const Real* wall, const Real* d, Real, Real r, Real* sum) const {
        const Real slope = kernel.slope_over_r(r) * wall[Wall::volume] * wall[Wall::grip];
        for (int a = 0; a < Dim; ++a) {
            const Real change = wall[Wall::mirrored_velocity + a] - water[Water::velocity + a];
            for (int b = 0; b < Dim; ++b) {
                sum[3 * a + b] = sum[3 * a + b] + slope * change * d[b];
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
    enum Field : int { velocity, volume = velocity + 3, stress, field_count = stress + tensor_numbers };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    // Places of the sums.
    static constexpr int at_force = 0, at_heat = 3;
    static constexpr int sums = 4, back_sums = sums;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* i, const Real* j, const Real* d, Real, Real r, Real* sum, Real* back) const {
        const Real slope = kernel.slope_over_r(r);
        Real both[tensor_numbers], force[3], heat(0);
        for (int k = 0; k < 3 * Dim; ++k) {
            both[k] = i[stress + k] + j[stress + k];
        }
        tensor_apply<Dim>(both, d, force);
        for (int a = 0; a < Dim; ++a) {
            force[a] = slope * force[a];
            heat = heat + force[a] * (i[velocity + a] - j[velocity + a]);
            sum[at_force + a] = sum[at_force + a] + j[volume] * force[a];
            back[at_force + a] = back[at_force + a] - i[volume] * force[a];
        }
        sum[at_heat] = sum[at_heat] - j[volume] * heat;
        back[at_heat] = back[at_heat] - i[volume] * heat;
    }
};

/// sums[0..2] = sum V_w 2 tau_i F d [N/m^3], sums[3] = -sum V_w (that force . (v_i - v_w)) [W/m^3]
struct TransposedFromWalls {
    struct Water {
        enum : int { velocity, stress = velocity + 3, count = stress + tensor_numbers };
    };
    struct Wall {
        enum : int { velocity, volume = velocity + 3, grip, count };
    };
    static constexpr int target_fields = Water::count, candidate_fields = Wall::count;
    // Places of the sums.
    static constexpr int at_force = 0, at_heat = 3;
    static constexpr int sums = 4;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* water, const Real* wall, const Real* d, Real, Real r, Real* sum) const {
        const Real slope = Real(2) * kernel.slope_over_r(r) * wall[Wall::volume] * wall[Wall::grip];
        Real force[3];
        tensor_apply<Dim>(water + Water::stress, d, force);
        for (int a = 0; a < Dim; ++a) {
            const Real v = water[Water::velocity + a] - wall[Wall::velocity + a];
            sum[at_force + a] = sum[at_force + a] + slope * force[a];
            sum[at_heat] = sum[at_heat] - slope * force[a] * v;
        }
    }
};

/// The opposite, per V_w: sums[0..2] = sum V_j 2 tau_j F d, d = x_w - x_j.
struct TransposedOnWalls {
    struct Wall {
        enum : int { grip, count };
    };
    struct Water {
        enum : int { volume, stress, count = stress + tensor_numbers };
    };
    static constexpr int target_fields = Wall::count, candidate_fields = Water::count;
    static constexpr int sums = 3;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* wall, const Real* water, const Real* d, Real, Real r, Real* sum) const {
        const Real slope = Real(2) * kernel.slope_over_r(r) * water[Water::volume] * wall[Wall::grip];
        Real force[3];
        tensor_apply<Dim>(water + Water::stress, d, force);
        for (int a = 0; a < Dim; ++a) {
            sum[a] = sum[a] + slope * force[a];
        }
    }
};

}  // namespace riprap::fluid
