// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/vec3.hpp"

namespace riprap::geometry {

/// Parts a polygon into triangles that wind as it does: a fan from its first corner where every triangle of that turns
/// like the polygon, as in convex ones, else by cutting ears [Meisters1975], whose time grows with the square of the
/// corners. What is left of a polygon that crosses itself, or of one that is not convex and has more than a thousand
/// corners, becomes a fan, some triangles of which turn against it.
/// @param face  its corners, numbers of `vertices`
std::vector<std::array<std::int32_t, 3>> triangles_of(std::span<const Vec3> vertices,
                                                      std::span<const std::int32_t> face);

}  // namespace riprap::geometry
