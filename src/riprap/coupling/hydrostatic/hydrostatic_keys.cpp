// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/key.hpp"
#include "riprap/coupling/hydrostatic/hydrostatic.hpp"

namespace riprap::coupling {

MethodKeys<HydrostaticSettings> HydrostaticSettings::keys() {
    using S = HydrostaticSettings;
    return {.help = "water at rest, its level given: buoyancy and uplift without waves",
            .keys = {key::number(&S::spacing, "spacing", dimension::length, key::positive(),
                                 "Size of the panels into which faces are cut to find joints.")
                         .required(),
                     key::number(&S::rest_density, "density", dimension::density, key::positive(),
                                 "At rest, without pressure."),
                     key::choice(&S::uplift, "uplift",
                                 {{"full", Uplift::full}, {"linear", Uplift::linear}, {"none", Uplift::none}},
                                 "Pressure between faces that lie on each other: that of the level; falling linearly "
                                 "from the wet end of the joint to none at the other; or none.")},
            .scene_keys = {"domain", "region", "levels"}};
}

}  // namespace riprap::coupling
