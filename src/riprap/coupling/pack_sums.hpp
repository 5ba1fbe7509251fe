// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/math.hpp"

namespace riprap::fluid {

/// Sums up the slope of the kernel, sum (dW/dr)/r d with d = x_i - x_j [1/m^4], in 2D [1/m^3]: over the count of
/// particles of one volume V, sum V grad W is V times that.
struct PackedSlope {
    static constexpr int target_fields = 0, candidate_fields = 0, sums = 3, back_sums = 3;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real*, const Real*, const Real* d, Real, Real r, Real* sum, Real* back) const {
        const Real slope = kernel.slope_over_r(r);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + slope * d[axis];
            back[axis] = back[axis] - slope * d[axis];
        }
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real*, const Real* d, Real, Real r, Real* sum) const {
        const Real slope = kernel.slope_over_r(r);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + slope * d[axis];
        }
    }
};

/// The same of what stays in its place, with a share of V for each.
struct PackedSlopeOfRest {
    static constexpr int target_fields = 0, candidate_fields = 1, sums = 3;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* rest, const Real* d, Real, Real r, Real* sum) const {
        const Real slope = rest[0] * kernel.slope_over_r(r);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + slope * d[axis];
        }
    }
};

/// Sums up W [1/m^3], in 2D [1/m^2], with a share of V for each.
struct PackedCount {
    static constexpr int target_fields = 0, candidate_fields = 1, sums = 1;
    WendlandC2 kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* other, const Real*, Real, Real r, Real* sum) const {
        sum[0] = sum[0] + other[0] * kernel.value(r);
    }
};

}  // namespace riprap::fluid
