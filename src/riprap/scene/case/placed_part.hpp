// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Spacings: water that lies against a face starts 0.5 to 1.5 of them away from it.
constexpr double touching = 1.5;

/// A part where it is in the world at the start.
struct PlacedPart {
    geometry::ConvexView shape;
    Pose pose;
};

PlacedPart placed(const CaseBuild& build, const body::Part& part);

/// The face that x lies in front of, not beside, at no more than `distance` [m]; -1 = none.
std::int32_t face_before(const PlacedPart& part, const Vec3& x, double distance);

/// Solids that water does not enter, placed once to be asked about many places.
class PlacedSolids {
 public:
    /// Gathers the solids that may reach into the box from `low` to `high` [m]. @param is_dry per body
    PlacedSolids(const CaseBuild& build, const std::vector<std::uint8_t>& is_dry, const Vec3& low, const Vec3& high);
    /// The solid that x is at least `depth` inside of [m]; invalid where there is none.
    BodyId at(const Vec3& x, double depth) const;

 private:
    std::vector<PlacedPart> parts_;
    std::vector<BodyId> bodies_;  ///< of each part
};

}  // namespace riprap::scene
