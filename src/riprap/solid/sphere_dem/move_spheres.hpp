// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/body_kinematics.hpp"
#include "riprap/body/body_set.hpp"

namespace riprap::solid::sphere_dem {

/// solid::drift, eight bodies at a time where they have three equal moments, as spheres do. Their orientations may
/// differ from those of drift() in the last digit: there the compiler contracts products of quaternions.
void drift_spheres(const body::BodySet& bodies, body::BodyState& state, double end_time, double dt);

/// body::update_kinematics, likewise eight at a time.
void update_sphere_kinematics(const body::BodySet& bodies, const body::BodyState& state, double time,
                              body::BodyKinematics& kinematics);

}  // namespace riprap::solid::sphere_dem
