// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/vec3.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::mellado {

/// Mean height of the free surface over a tank, z (in the plane y) where the water fraction is a half, along 17 by 3
/// (in the plane 17) upright lines a support inside its walls [m]. Unlike the sum of m/rho it sees how far apart the
/// particles stand. Lines nearer than a support to a body that floats or sinks are left out; NaN where that is all.
double mean_surface(const water::WaterTrial& trial, const Vec3& low, const Vec3& high);

/// Mean of a recorded mean_surface over the last `window` [s], rows without a line left out [m].
double last_surface(const water::WaterTrial& trial, const std::string& column, double window);

}  // namespace riprap::validation::mellado
