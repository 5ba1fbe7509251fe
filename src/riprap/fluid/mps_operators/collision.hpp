// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/sweep/math.hpp"

namespace riprap::fluid {

/// Changes of velocity by collisions [Mellado2021, eqs. 5.38, 5.39], signs as in docs/theory/wcmps.md, 6:
///
///     sums[0..2] = -min(s_i, s_j) sum (v.d) d/r^2 over pairs nearer than the collision distance that approach,
///
/// s = (1 + e)/2 over the number of pairs that a particle is in, 0 where it does not collide.
struct MpsCollision {
    enum Field : int { velocity, share = velocity + 3, field_count };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    static constexpr int mark = share;
    static constexpr bool needs_both_marks = true;
    static constexpr int sums = 3, back_sums = sums;
    double contact;  ///< square of the collision distance [m^2]
    double tiny;     ///< small against it, for a particle that meets itself [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real, Real* sum, Real* back) const {
        Real opening(0);
        for (int axis = 0; axis < Dim; ++axis) {
            opening = opening + (a[velocity + axis] - b[velocity + axis]) * d[axis];
        }
        const Real closing = select(r2 < Real(contact), min(opening, Real(0)), Real(0));
        const Real size = min(a[share], b[share]) * closing * reciprocal(r2 + Real(tiny));
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] - size * d[axis];
            back[axis] = back[axis] + size * d[axis];
        }
    }
};

}  // namespace riprap::fluid
