// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/sim/settings.hpp"

namespace riprap::body {
struct BodyState;
}

namespace riprap::sim {

struct Model;

/// Returns the settings of the solid method with values in place of those that the case leaves to the scene.
/// @param speed  of the hardest impact to come [m/s]
SolidSettings completed_settings(const Model& model, const body::BodyState& bodies, double speed);

}  // namespace riprap::sim
