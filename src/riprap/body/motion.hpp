// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "riprap/body/body_kinematics.hpp"
#include "riprap/core/bytes.hpp"

namespace riprap::body {

/// Acceleration of one body.
struct Acceleration {
    Vec3 linear{};   ///< of the centre of mass [m/s^2]
    Vec3 angular{};  ///< [rad/s^2]
};

/// Motion of every body at one moment, world axes. A point X of the body frame is at x = x_c + r, r = R U X, and moves
/// with v = v_c + omega x r + D r. Rigid bodies have U = 1 and D = 0: both arrays are empty where no body deforms.
struct Motion {
    std::vector<Pose> pose;                                ///< of the centre of mass
    std::vector<Vec3> velocity, angular_velocity;          ///< [m/s], [rad/s]
    std::vector<Vec3> acceleration, angular_acceleration;  ///< [m/s^2], [rad/s^2]
    std::vector<Sym3> stretch;                             ///< U, body axes [-]; empty: rigid bodies only
    std::vector<Sym3> stretch_rate;                        ///< D, world axes [1/s]; empty as `stretch`

    bool deforms() const { return !stretch.empty(); }
    std::size_t bytes() const {
        return bytes_of(pose, velocity, angular_velocity, acceleration, angular_acceleration, stretch, stretch_rate);
    }
};

/// r = R U X of body b [m].
inline Vec3 arm_of(const Motion& motion, std::size_t b, const Vec3& anchor) {
    return rotate(motion.pose[b].orientation, motion.deforms() ? motion.stretch[b] * anchor : anchor);
}

}  // namespace riprap::body
