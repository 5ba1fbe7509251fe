// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/quat.hpp"

namespace riprap::contact {

/// Pose of a part with the rotation as a matrix, computed once per step and part:
/// x_world = origin + axes * x_part.
struct Frame {
    Vec3 origin;
    Mat3 axes;
};

RIPRAP_HD inline Frame to_frame(const Pose& pose) { return {pose.position, to_matrix(pose.orientation)}; }

}  // namespace riprap::contact
