// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/viscosity/laminar_sps.hpp"

#include "riprap/core/key.hpp"

namespace riprap::fluid {

KeyList<LaminarSps> LaminarSps::keys() {
    return {key::number(&LaminarSps::kinematic_viscosity, "kinematic_viscosity", dimension::kinematic_viscosity,
                        key::non_negative(), "Kinematic viscosity of water."),
            key::number(&LaminarSps::smagorinsky, "smagorinsky", dimension::plain, key::between(0, 1),
                        "Constant of the turbulence model of laminar_sps.")};
}

}  // namespace riprap::fluid
