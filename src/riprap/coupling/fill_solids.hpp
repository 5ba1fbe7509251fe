// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/body/ground.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/geometry/shape_set.hpp"

namespace riprap::coupling {

/// The solids of a scene as filling sees them: all parts of all bodies, and the surfaces of ground.
class FillSolids {
 public:
    FillSolids(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state);
    bool contain(const Vec3& x) const;
    /// True inside of a solid, and outside where a surface is less than `distance` away [m].
    bool are_near(const Vec3& x, double distance) const;

 private:
    struct Placed {
        geometry::ConvexView shape;
        Pose pose;
    };
    std::vector<Placed> parts_;
    std::vector<body::Ground> grounds_;
    std::vector<Pose> poses_;  ///< of the grounds
};

}  // namespace riprap::coupling
