// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/scene/build_case.hpp"

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

/// The solid that water does not enter and that x is at least `depth` inside of [m]; invalid where there is none.
/// @param is_dry  per body
BodyId solid_at(const CaseBuild& build, const std::vector<std::uint8_t>& is_dry, const Vec3& x, double depth);

}  // namespace riprap::scene
