// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sums of a sound step on the geometry of a flow step (docs/theory/sph.md, 12): places x^g, volumes V and corrections B
// that stay the same while density, pressure and velocity go on. d = x^g_i - x^g_j, F = (dW/dr)/r.

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/sweep/math.hpp"
#include "riprap/fluid/particle/sweep/symmetric.hpp"

namespace riprap::fluid {

/// Change of density:
///
///     sums[0] = -sum V_j F (p_j - p_i + rho_0 g.d)   as Continuity
///     sums[1] =  sum V_j F (B_i d).v_ij              B:G of Continuity, contracted pair by pair [1/s]
struct SoundContinuity {
    enum Field : int {
        velocity,
        pressure = velocity + 3,
        volume,
        correction,
        field_count = correction + symmetric_numbers,
    };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    static constexpr int at_diffusion = 0, at_rate = 1;
    static constexpr int sums = 2, back_sums = 2;
    WendlandC2 kernel;
    double weight[3];  ///< rho_0 g [N/m^3]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real, Real r, Real* sum, Real* back) const {
        Real straight_a[3], straight_b[3];
        symmetric_apply<Dim>(a + correction, d, straight_a);
        symmetric_apply<Dim>(b + correction, d, straight_b);
        Real uneven = b[pressure] - a[pressure], closing_a(0), closing_b(0);
        for (int axis = 0; axis < Dim; ++axis) {
            const Real v = a[velocity + axis] - b[velocity + axis];
            uneven = uneven + Real(weight[axis]) * d[axis];
            closing_a = closing_a + straight_a[axis] * v;
            closing_b = closing_b + straight_b[axis] * v;
        }
        const Real slope = kernel.slope_over_r(r), slope_a = a[volume] * slope, slope_b = b[volume] * slope;
        sum[at_diffusion] = sum[at_diffusion] - slope_b * uneven;
        back[at_diffusion] = back[at_diffusion] + slope_a * uneven;
        sum[at_rate] = sum[at_rate] + slope_b * closing_a;
        back[at_rate] = back[at_rate] + slope_a * closing_b;
    }
};

/// Pressure force per V_i: sums[0..2] = -sum V_j (p_i B_i + p_j B_j) F d [N/m^3], the adjoint of SoundContinuity.
struct SoundForce {
    enum Field : int { volume, stress, field_count = stress + symmetric_numbers };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    static constexpr int sums = 3, back_sums = 3;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real, Real r, Real* sum, Real* back) const {
        Real pressed[symmetric_numbers], push[3];
        for (int k = 0; k < symmetric_used<Dim>; ++k) {
            pressed[k] = a[stress + k] + b[stress + k];
        }
        symmetric_apply<Dim>(pressed, d, push);
        const Real slope = kernel.slope_over_r(r), slope_a = a[volume] * slope, slope_b = b[volume] * slope;
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] - slope_b * push[axis];
            back[axis] = back[axis] + slope_a * push[axis];
        }
    }
};

/// sums[0..2] = sum a_w F d over walls: with a_w = V_w the slope of the walls, with V_w p_w what they press with.
struct WallSlope {
    static constexpr int target_fields = 0, candidate_fields = 1;
    static constexpr int sums = 3;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* wall, const Real* d, Real, Real r, Real* sum) const {
        const Real slope = wall[0] * kernel.slope_over_r(r);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + slope * d[axis];
        }
    }
};

/// Gradient of the concentration of particles in the water, as Continuity: sums[0..2] = sum V_j F d [1/m].
struct Concentration {
    static constexpr int target_fields = 1, candidate_fields = 1;
    static constexpr int sums = 3, back_sums = 3;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real, Real r, Real* sum, Real* back) const {
        const Real slope = kernel.slope_over_r(r), slope_a = a[0] * slope, slope_b = b[0] * slope;
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + slope_b * d[axis];
            back[axis] = back[axis] - slope_a * d[axis];
        }
    }
};

/// The water as walls see it: sums[0] = sum p_j W of WallAverages, sums[1..3] = sum V_j p_j F B_j d of PressureOnWalls,
/// d = x_w - x^g_j.
struct SoundOnWalls {
    struct Water {
        enum : int { pressure, volume, stress, count = stress + symmetric_numbers };
    };
    static constexpr int target_fields = 0, candidate_fields = Water::count;
    static constexpr int at_pressure = 0, at_push = 1;
    static constexpr int sums = 4;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* water, const Real* d, Real, Real r, Real* sum) const {
        Real push[3];
        symmetric_apply<Dim>(water + Water::stress, d, push);
        const Real slope = water[Water::volume] * kernel.slope_over_r(r);
        sum[at_pressure] = sum[at_pressure] + kernel.value(r) * water[Water::pressure];
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_push + axis] = sum[at_push + axis] + slope * push[axis];
        }
    }
};

}  // namespace riprap::fluid
