// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Warns of densities of free bodies and of the water that are those of another unit.
void warn_of_densities(CaseBuild& build);

}  // namespace riprap::scene
