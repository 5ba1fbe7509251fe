// SPDX-License-Identifier: Apache-2.0
#include "riprap/material/strength_reduction.hpp"

#include <algorithm>

namespace riprap::material {

double StrengthReduction::divisor(double time) const {
    const double u = std::clamp((time - begins) / over, 0.0, 1.0);
    return from + (to - from) * (u * u * u * (10 - u * (15 - 6 * u)));
}

StrengthReduction StrengthReduction::held() const {
    StrengthReduction same = *this;
    same.to = from;
    return same;
}

void reduce_strength(const MaterialSet& full, const StrengthReduction& reduction, double divisor,
                     MaterialSet& reduced) {
    if (reduced.size() != full.size()) {
        reduced = full;
    }
    for (std::size_t i = 0; i < full.pairs.size(); ++i) {
        const PairProperties& whole = full.pairs[i];
        PairProperties& pair = reduced.pairs[i];
        pair.friction = reduction.has_friction ? whole.friction / divisor : whole.friction;
        pair.cohesion = reduction.has_cohesion ? whole.cohesion / divisor : whole.cohesion;
        pair.tensile_strength = reduction.has_tension ? whole.tensile_strength / divisor : whole.tensile_strength;
    }
}

}  // namespace riprap::material
