// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/config.hpp"
#include "riprap/fluid/particle/math.hpp"

namespace riprap::fluid {

/// Weight of neighbours in moving particle methods [KoshizukaOka1996],
///
///     W(r) = r_e/r - 1,   r < r_e,
///
/// exactly zero at and beyond the support radius r_e, and made zero where a particle meets itself. Dimensionless.
///
/// Differs from the source: pairs nearer than half a spacing l_0 weigh as much as at half a spacing. W/r^2 has no bound
/// there: in splash, where collisions and shifting keep few particles apart, one near miss within one explicit step
/// threw a particle out at ten times the speed of the water, with energy that nobody had given.
class MpsWeight {
 public:
    MpsWeight() = default;
    /// @param support_radius  r_e [m]
    /// @param spacing         l_0 [m]
    MpsWeight(double support_radius, double spacing) : reach_(support_radius), nearest_(0.25 * spacing * spacing) {}

    /// W [-]. @param r2 r^2 [m^2]
    template <class Real>
    RIPRAP_HD Real value(Real r2) const {
        const Real inverse = reciprocal_sqrt(max(r2, Real(nearest_)));
        return select(r2 < Real(4e-8 * nearest_), Real(0), max(Real(reach_) * inverse - Real(1), Real(0)));
    }
    /// W/r^2 [1/m^2]: what differences along r are weighted with; times d finite at r = 0.
    template <class Real>
    RIPRAP_HD Real over_square(Real r2, Real weight) const {
        return weight * reciprocal(max(r2, Real(nearest_)));
    }

 private:
    double reach_{0}, nearest_{1};  ///< r_e [m], (l_0/2)^2 [m^2]
};

}  // namespace riprap::fluid
