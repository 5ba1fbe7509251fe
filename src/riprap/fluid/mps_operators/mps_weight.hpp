// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/config.hpp"
#include "riprap/fluid/mps_operators/mps_choices.hpp"
#include "riprap/fluid/particle/sweep/math.hpp"

namespace riprap::fluid {

/// Weight of neighbours in moving particle methods, with q = r/r_e < 1:
///
///     smooth:      W(r) = q^2 (1 - q)^3
///     reciprocal:  W(r) = 1/q - 1          [KoshizukaOka1996]
///
/// exactly zero at and beyond the support radius r_e, and where a particle meets itself. Dimensionless.
///
/// Gradients, divergences and forces weigh pairs by W/r^2. By the smooth law that is (1 - q)^3/r_e^2, the slope over
/// distance of Wendland's C2 kernel [Wendland1995]: it has a bound, falls to zero without a kink, and its sums over
/// lattices all but equal integrals, so rows of particles slide over each other. By the reciprocal law it grows as
/// 1/r^3: rows lock, and water under a pressure p bears a shear of about 0.01 p at rest, as if it had a yield stress
/// (docs/theory/wcmps.md, 1).
///
/// The reciprocal law differs from the source: pairs nearer than half a spacing l_0 weigh as much as at half a spacing.
/// W/r^2 has no bound there: in splash, where collisions and shifting keep few particles apart, one near miss within
/// one explicit step threw a particle out at ten times the speed of the water, with energy that nobody had given.
class MpsWeight {
 public:
    MpsWeight() = default;
    /// @param support_radius  r_e [m]
    /// @param spacing         l_0 [m]
    MpsWeight(double support_radius, double spacing, MpsWeightLaw law)
        : reach_(support_radius),
          nearest_((law == MpsWeightLaw::reciprocal ? 0.25 : tiny) * spacing * spacing),
          is_smooth_(law == MpsWeightLaw::smooth) {}

    /// W [-]. @param r2 r^2 [m^2]
    template <class Real>
    RIPRAP_HD Real value(Real r2) const {
        const Real inverse = reciprocal_sqrt(max(r2, Real(nearest_)));
        if (is_smooth_) {
            const Real q = r2 * inverse * Real(1 / reach_), rest = max(Real(1) - q, Real(0));
            return q * q * rest * rest * rest;
        }
        return select(r2 < Real(4e-8 * nearest_), Real(0), max(Real(reach_) * inverse - Real(1), Real(0)));
    }
    /// W/r^2 [1/m^2]: what differences along r are weighted with; times d finite at r = 0.
    template <class Real>
    RIPRAP_HD Real over_square(Real r2, Real weight) const {
        return weight * reciprocal(max(r2, Real(nearest_)));
    }

 private:
    static constexpr double tiny = 1e-8;  ///< square of a distance at which particles all but coincide, over l_0^2

    double reach_{1}, nearest_{1};  ///< r_e [m]; pairs are no nearer than the root of this [m^2]
    bool is_smooth_{false};
};

}  // namespace riprap::fluid
