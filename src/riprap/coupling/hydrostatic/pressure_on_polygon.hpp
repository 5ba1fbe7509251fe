// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/core/vec3.hpp"

namespace riprap::coupling {

/// Integrals of a pressure p over a flat polygon: of p [N] and of p r [N m], r from the origin of its corners.
struct PressureIntegral {
    double of_pressure{0};
    Vec3 of_moment{};
    friend PressureIntegral operator*(double share, const PressureIntegral& p) {
        return {share * p.of_pressure, share * p.of_moment};
    }
};

/// Returns the integrals of p = weight (level - up . r) over the part of a convex polygon that lies below the level,
/// exact: p and r are linear, so over a triangle of area A with corners i
///
///     int p dA = A sum p_i/3,   int p r dA = A/12 (sum p_i sum r_i + sum p_i r_i).
///
/// @param weight  rho |g| [N/m^3]
PressureIntegral pressure_on_polygon(std::span<const Vec3> corners, const Vec3& up, double level, double weight);

/// Returns the unit normal of a flat polygon, corners counter-clockwise about it [-]; 0 without area.
Vec3 normal_of(std::span<const Vec3> corners);

}  // namespace riprap::coupling
