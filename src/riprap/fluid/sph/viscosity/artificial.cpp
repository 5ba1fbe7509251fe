// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/viscosity/artificial.hpp"

#include "riprap/core/key.hpp"

namespace riprap::fluid {

KeyList<ArtificialViscosity> ArtificialViscosity::keys() {
    return {key::number(&ArtificialViscosity::alpha, "artificial_alpha", dimension::plain, key::between(0, 1),
                        "Strength of the artificial viscosity.")};
}

}  // namespace riprap::fluid
