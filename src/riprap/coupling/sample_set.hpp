// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/core/ids.hpp"
#include "riprap/core/vec3.hpp"

namespace riprap::coupling {

/// Points of the solids that a fluid feels and that carry its loads back: the only place where both sides meet. Made
/// once from the shapes, in the order of the bodies; what they are attached to moves them and takes their loads by the
/// transpose of the same map (rigid: force and torque; deformable: T(x)^T f), so power is conserved.
struct SampleSet {
    std::vector<BodyId> body;
    std::vector<Vec3> anchor;               ///< place in the body frame [m]
    std::vector<Vec3> normal;               ///< outward, body frame [-]
    std::vector<double> depth;              ///< below the surface, positive inside [m]
    std::vector<double> volume;             ///< [m^3]; in 2D [m^2]
    std::vector<std::uint8_t> is_slippery;  ///< free slip

    std::int64_t size() const { return static_cast<std::int64_t>(anchor.size()); }
};

}  // namespace riprap::coupling
