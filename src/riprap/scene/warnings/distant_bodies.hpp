// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Bodies that do not follow forces and lie farther from all that moves, free bodies and the domain of the water, than
/// a thousand times the size of either: ground in coordinates of its own that lacks an origin.
void warn_of_distant_bodies(CaseBuild& build);

}  // namespace riprap::scene
