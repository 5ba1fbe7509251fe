// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "riprap/body/body_set.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::coupling {

/// A pressure transducer in a face of a body, which it stays with as the body moves.
struct FaceGauge {
    BodyId body;
    Vec3 anchor;  ///< on the face, body frame [m]
    Vec3 normal;  ///< unit vector out of the body there, body frame [-]
    /// Of the square that it takes the mean over, one of its sides along `tangent`; 0 = as small as the water resolves
    /// [m].
    double side{0};
};

/// A unit vector along a face, the same whatever way its body is turned: first side of the square of a sensor. In two
/// dimensions it is in the plane. The other side is across the normal and this one.
/// @param normal  of the face in the frame of the body
Vec3 tangent(const Vec3& normal, bool is_planar);

/// The face nearest to a place among those of bodies that are not dry, faces between parts of one body left out;
/// nothing where none lies within `reach`. Of faces equally near, as in a corner, the first.
/// @param is_dry  per body: feels no water; empty = none
/// @param only    faces of this body alone; invalid = of any
std::optional<FaceGauge> find_face(const geometry::ShapeSet& shapes, const body::BodySet& bodies,
                                   const body::BodyState& initial, std::span<const std::uint8_t> is_dry,
                                   const Vec3& place, double reach, BodyId only = {});

}  // namespace riprap::coupling
