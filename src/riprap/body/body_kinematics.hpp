// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/body/body_set.hpp"

namespace riprap::body {

/// Kinematics of every body at one pose, for contact laws and the kick: Scratch. A body that forces do not move has
/// inverse mass and inverse inertia zero.
struct BodyKinematics {
    std::vector<Vec3> angular_velocity;  ///< world axes [rad/s]
    std::vector<Sym3> inverse_inertia;   ///< world axes [1/(kg m^2)]
    std::vector<double> inverse_mass;    ///< [1/kg]
};

/// Fills `kinematics` for all bodies at the poses of `state`, which are those of `time` (driven bodies included).
void update_kinematics(const BodySet& bodies, const BodyState& state, double time, BodyKinematics& kinematics);
/// Fills `kinematics`, which has room for all bodies, for one body.
void update_kinematics_of(const BodySet& bodies, const BodyState& state, std::int64_t index, double time,
                          BodyKinematics& kinematics);

}  // namespace riprap::body
