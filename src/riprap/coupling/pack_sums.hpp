// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/sweep/math.hpp"

namespace riprap::fluid {

/// Sums up the slope of the kernel, sum (dW/dr)/r d with d = x_i - x_j [1/m^4], in 2D [1/m^3]: over the count of
/// particles of one volume V, sum V grad W is V times that.
///
/// Differs from that where a pair is nearer than r_n: it pushes by k (r_n - r) more. The slope of the kernel vanishes
/// at r = 0, so that particles which a corner presses together stayed in one place.
struct PackedSlope {
    static constexpr int target_fields = 0, candidate_fields = 0, sums = 3, back_sums = 3;
    WendlandC2 kernel;
    double nearest{0};  ///< r_n [m]
    double push{0};     ///< k [1/m^5], in 2D [1/m^4]

    /// @param spacing  dp [m]
    /// @param volume   V [m^3], in 2D [m^2]
    static PackedSlope of(const WendlandC2& kernel, double spacing, double volume) {
        constexpr double nearest_share = 0.5;  // r_n/dp
        constexpr double push_share = 1;  // V k dp^2: a pair in one place pushes by half of 1/dp, more than corners do
        return {kernel, nearest_share * spacing, push_share / (volume * spacing * spacing)};
    }
    /// (dW/dr)/r, and the push of near pairs over r
    template <class Real>
    RIPRAP_HD Real slope_over_r(Real r) const {
        const Real apart = max(r, Real(1e-3 * nearest));
        return kernel.slope_over_r(r) - Real(push) * max(Real(nearest) - r, Real(0)) * reciprocal(apart);
    }

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real*, const Real*, const Real* d, Real, Real r, Real* sum, Real* back) const {
        const Real slope = slope_over_r(r);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + slope * d[axis];
            back[axis] = back[axis] - slope * d[axis];
        }
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real*, const Real* d, Real, Real r, Real* sum) const {
        const Real slope = slope_over_r(r);
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
