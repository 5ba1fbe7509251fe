// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pair physics at the free surface of weakly compressible MPS, with d = x_i - x_j, v = v_i - v_j, W the weight.

#include "riprap/fluid/mps_operators/mps_weight.hpp"

namespace riprap::fluid::wcmps {

/// Surface particles around, f = 1 in class F:
///
///     sums[0] = number in class F within 2.1 l_0,   sums[1..3] = sum f_j n_j W [Mellado2021, eq. 5.37]
struct MpsSurface {
    enum Field : int {
        is_surface,  ///< f
        normal,      ///< f n
        field_count = normal + 3,
    };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    static constexpr int mark = is_surface;  ///< pairs without class F add nothing, see particle/patch_sweep.hpp
    static constexpr bool needs_both_marks = false;
    // Places of the sums.
    static constexpr int at_adjacent = 0, at_normal = 1;
    static constexpr int sums = 4, back_sums = sums;
    MpsWeight weight;
    double adjacent;  ///< square of 2.1 l_0 [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real*, Real r2, Real, Real* sum, Real* back) const {
        const Real w = weight.value(r2), reached = select(Real(0) < w, Real(1), Real(0));
        const Real is_adjacent = select(r2 < Real(adjacent), reached, Real(0));
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_normal + axis] = sum[at_normal + axis] + b[normal + axis] * w;
            back[at_normal + axis] = back[at_normal + axis] + a[normal + axis] * w;
        }
        sum[at_adjacent] = sum[at_adjacent] + b[is_surface] * is_adjacent;
        back[at_adjacent] = back[at_adjacent] + a[is_surface] * is_adjacent;
    }
};

/// Pairs about to collide, of which one particle or both may, s > 0:
///
///     sums[0] = number nearer than the collision distance that approach
struct MpsApproach {
    enum Field : int { velocity, share = velocity + 3, field_count };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    static constexpr int mark = share;
    static constexpr bool needs_both_marks = false;
    static constexpr int sums = 1, back_sums = sums;
    double contact;  ///< square of the collision distance [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real, Real* sum, Real* back) const {
        Real opening(0);
        for (int axis = 0; axis < Dim; ++axis) {
            opening = opening + (a[velocity + axis] - b[velocity + axis]) * d[axis];
        }
        const Real may = select(Real(0) < a[share] + b[share], Real(1), Real(0));
        const Real one = select(r2 < Real(contact), select(opening < Real(0), may, Real(0)), Real(0));
        sum[0] = sum[0] + one;
        back[0] = back[0] + one;
    }
};

}  // namespace riprap::fluid::wcmps
