// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/viscosity/artificial.hpp"

#include "riprap/core/key.hpp"

namespace riprap::fluid {

KeyList<ArtificialViscosity> ArtificialViscosity::keys() {
    return {key::number(&ArtificialViscosity::alpha, "artificial_alpha", dimension::plain, key::between(0, 1),
                        "Strength of the artificial viscosity."),
            key::boolean(&ArtificialViscosity::spares_smooth, "spare_smooth_flow",
                         "Artificial viscosity acts on particles whose neighbours move at random, not where velocity "
                         "is linear in space: waves keep their energy, noise loses it.")
                .read_with("scheme", {"delta_sph"})
                .read_above("artificial_alpha", 0)};
}

}  // namespace riprap::fluid
