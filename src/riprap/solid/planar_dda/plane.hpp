// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "riprap/core/quat.hpp"
#include "riprap/geometry/planar/planar_vector.hpp"

// Places and turns of bodies, as seen in the x-y plane.

namespace riprap::solid::planar_dda {

inline geometry::Vec2 flat(const Vec3& x) { return {x.x, x.y}; }
inline double angle_of(const Quat& turn) { return 2 * std::atan2(turn.z, turn.w); }
inline Quat turn_of(double angle) { return {std::cos(0.5 * angle), 0, 0, std::sin(0.5 * angle)}; }
inline geometry::Vec2 turned(double angle, const geometry::Vec2& x) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * x.x - s * x.y, s * x.x + c * x.y};
}

}  // namespace riprap::solid::planar_dda
