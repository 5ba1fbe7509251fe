// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "riprap/body/body_set.hpp"
#include "riprap/geometry/shape_set.hpp"

namespace riprap::coupling {

/// A pressure transducer in a face of a body, which it stays with as the body moves.
struct FaceGauge {
    BodyId body;
    Vec3 anchor;  ///< on the face, body frame [m]
    Vec3 normal;  ///< unit vector out of the body there, body frame [-]
};

/// The face nearest to a place among those of bodies that are not dry, faces between parts of one body left out;
/// nothing where none lies within `reach`. Of faces equally near, as in a corner, the first.
/// @param is_dry  per body: feels no water; empty = none
/// @param only    faces of this body alone; invalid = of any
std::optional<FaceGauge> find_face(const geometry::ShapeSet& shapes, const body::BodySet& bodies,
                                   const body::BodyState& initial, std::span<const std::uint8_t> is_dry,
                                   const Vec3& place, double reach, BodyId only = {});

}  // namespace riprap::coupling
