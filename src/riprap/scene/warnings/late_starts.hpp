// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Warns of loads, motions, releases and turns of gravity that begin when the run is over, as times in another unit do,
/// and of loads that stop before they have grown to their size.
void warn_of_late_starts(CaseBuild& build);

/// Warns of friction coefficients that are angles.
void warn_of_steep_friction(CaseBuild& build);

}  // namespace riprap::scene
