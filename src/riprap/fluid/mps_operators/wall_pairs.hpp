// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pair physics between water and walls of both moving particle methods, with d = x_w - x_j, W the weight, x = n/n_0,
// which is 1 in semi-implicit MPS, q = p/x.

#include "riprap/fluid/mps_operators/mps_weight.hpp"
#include "riprap/fluid/particle/sweep/symmetric.hpp"

namespace riprap::fluid {

/// Averages of the fluid at wall particles [Adami2012, eqs. 22, 23, 27]:
///
///     sums[0] = sum W,   sums[1] = sum p_j W,   sums[2..4] = rho_0 sum d W,   sums[5..7] = sum v_j W.
struct MpsWallAverages {
    struct Water {
        enum : int { velocity, pressure = velocity + 3, count };
    };
    static constexpr int target_fields = 0, candidate_fields = Water::count;
    // Places of the sums.
    static constexpr int at_weight = 0, at_pressure = 1, at_moment = 2, at_velocity = 5;
    static constexpr int sums = 8;
    MpsWeight weight;
    double rest_density;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* water, const Real* d, Real r2, Real, Real* sum) const {
        const Real w = weight.value(r2), heavy = Real(rest_density) * w;
        sum[at_weight] = sum[at_weight] + w;
        sum[at_pressure] = sum[at_pressure] + water[Water::pressure] * w;
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_moment + axis] = sum[at_moment + axis] + heavy * d[axis];
            sum[at_velocity + axis] = sum[at_velocity + axis] + water[Water::velocity + axis] * w;
        }
    }
};

/// Pressure loads on wall particles in three parts that do not depend on how walls move, with d = x_w - x_j:
///
///     sums[0..2] = sum x_j d W/r^2,    sums[3..5] = sum q_j d W/r^2,    sums[6..11] = sum d d^T W/r^2,
///
/// b ((1 + m) sums[3..5] + (A + H) sums[0..2] + sums[6..11] h) being the reaction to wcmps::MpsMomentumFromWalls.
struct MpsPressureOnWalls {
    struct Water {
        enum : int { concentration, pressure_over_concentration, count };
    };
    static constexpr int target_fields = 0, candidate_fields = Water::count;
    // Places of the sums.
    static constexpr int at_slope = 0, at_push = 3, at_moment = 6;
    static constexpr int sums = 6 + symmetric_numbers;
    MpsWeight weight;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* water, const Real* d, Real r2, Real, Real* sum) const {
        const Real over_square = weight.over_square(r2, weight.value(r2));
        Real moment[symmetric_numbers];
        symmetric_square<Dim>(d, moment);
        for (int axis = 0; axis < Dim; ++axis) {
            const Real slope = over_square * d[axis];
            sum[at_slope + axis] = sum[at_slope + axis] + water[Water::concentration] * slope;
            sum[at_push + axis] = sum[at_push + axis] + water[Water::pressure_over_concentration] * slope;
        }
        for (int k = 0; k < symmetric_used<Dim>; ++k) {
            sum[at_moment + k] = sum[at_moment + k] + over_square * moment[k];
        }
    }
};

/// And viscous loads: sums[0..2] = k grip sum (v_j - u_w) W.
struct MpsViscosityOnWalls {
    struct Wall {
        enum : int { mirrored_velocity, grip = mirrored_velocity + 3, count };
    };
    struct Water {
        enum : int { velocity, count = velocity + 3 };
    };
    static constexpr int target_fields = Wall::count, candidate_fields = Water::count;
    static constexpr int sums = 3;
    MpsWeight weight;
    double viscosity;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* wall, const Real* water, const Real*, Real r2, Real, Real* sum) const {
        const Real drag = Real(viscosity) * wall[Wall::grip] * weight.value(r2);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + drag * (water[Water::velocity + axis] - wall[Wall::mirrored_velocity + axis]);
        }
    }
};

}  // namespace riprap::fluid
