// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/sweep/math.hpp"

namespace riprap::fluid {

/// Averages of the fluid at a wall particle, from which its pressure and mirrored velocity follow [Adami2012, eqs. 22,
/// 23, 27], with d = x_w - x_j:
///
///     sums[0] = sum W,   sums[1] = sum p_j W,   sums[2..4] = sum rho_j d W,   sums[5..7] = sum v_j W.
struct WallAverages {
    struct Water {
        enum : int { velocity, pressure = velocity + 3, density, count };
    };
    static constexpr int target_fields = 0, candidate_fields = Water::count;
    // Places of the sums.
    static constexpr int at_weight = 0, at_pressure = 1, at_moment = 2, at_velocity = 5;
    static constexpr int sums = 8;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* water, const Real* d, Real, Real r, Real* sum) const {
        const Real weight = kernel.value(r);
        sum[at_weight] = sum[at_weight] + weight;
        sum[at_pressure] = sum[at_pressure] + weight * water[Water::pressure];
        const Real moment = weight * water[Water::density];
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_moment + axis] = sum[at_moment + axis] + moment * d[axis];
            sum[at_velocity + axis] = sum[at_velocity + axis] + weight * water[Water::velocity + axis];
        }
    }
};

}  // namespace riprap::fluid
