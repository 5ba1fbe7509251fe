// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "riprap/core/config.hpp"
#include "riprap/fluid/particle/sweep/math.hpp"

namespace riprap::fluid {

/// Wendland's C2 kernel in two and three dimensions [Wendland1995],
///
///     W(r) = alpha (1 - q/2)^4 (1 + 2 q),      q = r/h < 2,
///     (dW/dr)/r = -5 alpha/h^2 (1 - q/2)^3,
///     alpha = 7/(4 pi h^2) in 2D, 21/(16 pi h^3) in 3D,
///
/// and exactly zero at and beyond q = 2. The gradient with respect to x_i is ((dW/dr)/r) d with d = x_i - x_j: no
/// division by r, finite where a particle meets itself.
class WendlandC2 {
 public:
    WendlandC2() = default;
    /// @param smoothing_length  h [m]
    /// @param dimension         2 or 3
    WendlandC2(double smoothing_length, int dimension)
        : half_inverse_(0.5 / smoothing_length),
          peak_(dimension == 2 ? 7 / (4 * std::numbers::pi * smoothing_length * smoothing_length)
                               : 21 / (16 * std::numbers::pi * smoothing_length * smoothing_length * smoothing_length)),
          slope_peak_(-5 * peak_ / (smoothing_length * smoothing_length)) {}

    /// W [1/m^3], in 2D [1/m^2]. @param r distance [m]
    template <class Real>
    RIPRAP_HD Real value(Real r) const {
        const Real rest = remaining(r);
        const Real square = rest * rest;
        return Real(peak_) * square * square * (Real(5) - Real(4) * rest);  // 1 + 2q = 5 - 4 (1 - q/2)
    }
    /// (dW/dr)/r [1/m^5], in 2D [1/m^4]; never positive.
    template <class Real>
    RIPRAP_HD Real slope_over_r(Real r) const {
        const Real rest = remaining(r);
        return Real(slope_peak_) * rest * rest * rest;
    }

 private:
    /// 1 - q/2 inside the support, else 0
    template <class Real>
    RIPRAP_HD Real remaining(Real r) const {
        return max(Real(1) - r * Real(half_inverse_), Real(0));
    }

    double half_inverse_{0};  ///< 1/(2 h) [1/m]
    double peak_{0};          ///< alpha = W(0)
    double slope_peak_{0};    ///< (dW/dr)/r at r = 0
};

}  // namespace riprap::fluid
