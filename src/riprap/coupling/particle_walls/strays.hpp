// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::coupling {

/// Particles that lie where a solid is.
struct Strays {
    std::int64_t count{0};
    BodyId body;      ///< in which the deepest lies
    double depth{0};  ///< of the deepest below the nearest face [m]
};

/// Counts particles that have passed through a face: deeper than `least` inside a convex part of a body that holds
/// water. Water stands half a spacing before a face; the guard lets none deeper than a few tenths behind it.
/// @param is_dry  per body, of those that water does not feel; empty = none
Strays find_strays(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
                   std::span<const std::uint8_t> is_dry, const std::vector<Vec3>& particles, double least);

}  // namespace riprap::coupling
