// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/body/body_set.hpp"

namespace riprap::body {

/// A symmetric 3x3 matrix.
struct Sym3 {
    double xx{0}, yy{0}, zz{0}, xy{0}, xz{0}, yz{0};
};

RIPRAP_HD constexpr Vec3 operator*(const Sym3& m, const Vec3& v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

/// What contact laws and the kick need to know of every body at one pose: Scratch. A body that forces do not move has
/// inverse mass and inverse inertia zero.
struct BodyKinematics {
    std::vector<Vec3> angular_velocity;  ///< world axes [rad/s]
    std::vector<Sym3> inverse_inertia;   ///< world axes [1/(kg m^2)]
    std::vector<double> inverse_mass;    ///< [1/kg]
};

/// Fills `kinematics` for all bodies at the poses of `state`, which are those of `time` (driven bodies included).
void update_kinematics(const BodySet& bodies, const BodyState& state, double time, BodyKinematics& kinematics);

}  // namespace riprap::body
