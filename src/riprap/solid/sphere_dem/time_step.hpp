// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/solid/sphere_dem/sphere_model.hpp"

namespace riprap::solid::sphere_dem {

/// Highest speed of a point that may strike another one [m/s]: that of the centre of a ball, whose spin brings nothing
/// nearer, else of the farthest point of a body. A rod that turns about its centre strikes with its ends.
double fastest_point(const SphereModel& model, const body::BodyState& state);

/// The sphere that limits the step.
struct SphereStep {
    double limit;  ///< [s]; infinity where no sphere can touch anything
    BodyId body;
    std::string reason;
};

/// Longest step of the explicit scheme [s]: the shortest impact over `steps_per_contact`,
///
///     dt = 2.87 (m*^2/(R* E*^2 v))^(1/5)/steps_per_contact,   v = max(2 v_max, sqrt(2 g D)),
///
/// of every free body's smallest sphere against a sphere and body like itself, and against the stiffest pair of
/// materials and an immovable plane (m* = m, R* = R) or the lightest body with faces that moves, shorter by N^(2/5)
/// where a flat side of N spheres may land at once and springs add up; a linear spring has the duration pi sqrt(m*/k)
/// for any v. The floor of v is free fall over one diameter D [Mellado2021, eq. 4.26, with the exponent 1/5].
///
/// @param gravity  size of gravity [m/s^2]
SphereStep step_limit(const SphereModel& model, const body::BodyState& state, double gravity);

}  // namespace riprap::solid::sphere_dem
