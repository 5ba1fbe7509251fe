// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/key.hpp"
#include "riprap/fluid/mps_operators/mps_choices.hpp"

namespace riprap::fluid {

/// Keys that moving particle methods share, bound to the members of their settings S.
template <class S>
KeyList<S> mps_keys() {
    return {key::choice(&S::weight_law, "weight",
                        {{"smooth", MpsWeightLaw::smooth}, {"reciprocal", MpsWeightLaw::reciprocal}},
                        "Weight of neighbours at r, with q = r over the support: smooth, q^2 (1 - q)^3; or "
                        "reciprocal, 1/q - 1 as in the source, by which still water bears a shear of about 1 % of its "
                        "pressure and holds what should rise or sink."),
            key::choice(&S::wall_pressure, "wall_pressure",
                        {{"averaged", MpsWallPressure::averaged}, {"mirrored", MpsWallPressure::mirrored}},
                        "Pressure of walls: the mean of the water about them; or that of each particle, mirrored, by "
                        "which the water next to a moving body is dragged along (for comparison).")};
}

}  // namespace riprap::fluid
