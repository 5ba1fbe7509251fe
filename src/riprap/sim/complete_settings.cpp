// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/complete_settings.hpp"

#include "riprap/sim/methods.hpp"
#include "riprap/sim/model.hpp"

namespace riprap::sim {

SolidSettings completed_settings(const Model& model, const body::BodyState& bodies, double speed) {
    return Solids::visit(model.solid, [&]<class Solid>(const typename Solid::Settings& settings) -> SolidSettings {
        return Solid::traits.completed(solid_scene(model), settings, bodies, speed);
    });
}

}  // namespace riprap::sim
