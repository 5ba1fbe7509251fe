// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/body/body_kinematics.hpp"
#include "riprap/body/motion.hpp"

namespace riprap::body {

/// Fills the motion of all bodies with the poses and velocities of `state`, `ahead` seconds of acceleration later.
/// Driven bodies accelerate as their motion says and by their `correction`, where there are any [m/s^2].
/// @param kinematics    at those poses
/// @param acceleration  of free bodies
/// @param time          of the motion [s]
/// @param dt            of the step over which jumps of driven velocities are spread [s]
void fill_motion(const BodySet& bodies, const BodyState& state, const BodyKinematics& kinematics,
                 std::span<const Acceleration> acceleration, std::span<const Vec3> correction, double time,
                 double ahead, double dt, Motion& motion);

}  // namespace riprap::body
