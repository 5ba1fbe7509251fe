// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/material/material_set.hpp"

namespace riprap::material {

/// Division of the strengths of all pairs of materials by a factor that changes during a run: reduction of strength, by
/// which a factor of safety is found. Coefficient of friction, cohesion and tensile strength [Zienkiewicz1975],
///
///     tan(phi)/D,  c/D,  t/D;   D(t) = from + (to - from) s((t - begins)/over),   s(u) = u^3 (10 - 15 u + 6 u^2),
///
/// with s = 0 before and 1 after. s has no jump in its second derivative, so no impact follows from the change. Rolling
/// friction, stiffnesses, bolts and fixed points stay. Valid for D > 0.
struct StrengthReduction {
    double from{1}, to{1};      ///< D before and after [-]
    double begins{0}, over{1};  ///< [s]
    bool has_friction{true};    ///< friction is divided
    bool has_cohesion{true};
    bool has_tension{true};

    /// Tells whether D ever differs from 1.
    bool is_active() const { return from != 1 || to != 1; }
    /// Returns D at a time.
    double divisor(double time) const;
    /// Returns the reduction that stays as it is before it begins.
    StrengthReduction held() const;
};

/// Writes the pairs of `full` with divided strengths into `reduced`; everything else is copied where `reduced` is
/// empty.
void reduce_strength(const MaterialSet& full, const StrengthReduction& reduction, double divisor, MaterialSet& reduced);

}  // namespace riprap::material
