// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/sph/muller_kernels.hpp"

namespace riprap::fluid {

/// rho_i = sum m W: sums[0] = sum m_j W, the particle itself included.
struct DensitySum {
    enum Field : int { mass, field_count };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    static constexpr int sums = 1, back_sums = 1;
    Poly6Kernel kernel;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real*, Real r2, Real, Real* sum, Real* back) const {
        const Real weight = kernel.value_at(r2);
        sum[0] = sum[0] + b[mass] * weight;
        back[0] = back[0] + a[mass] * weight;
    }
};

}  // namespace riprap::fluid
