// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/scene/case/case_build.hpp"
#include "riprap/scene/loaded_case.hpp"

namespace riprap::scene {

/// Speed of the hardest impact that can be foreseen: of free bodies that start with a velocity, turn, or fall onto what
/// lies below their centre, now or when they are let go, and of driven ones that turn or move towards a free one,
/// within the time of the run [m/s].
double impact_speed(const sim::Model& model, const sim::State& state);

/// Gives the solid method the values that the case leaves to it and that follow from the scene, and notes them.
void complete_solid(CaseBuild& build);

/// Returns the resolved case with these values in place of "auto".
std::string completed_toml(const LoadedCase& loaded);

}  // namespace riprap::scene
