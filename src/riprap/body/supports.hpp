// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/ids.hpp"
#include "riprap/core/vec3.hpp"

namespace riprap::body {

/// A point of a body that a spring in every direction holds at its place: a fixed point.
struct FixedPoint {
    BodyId body;
    Vec3 point{};         ///< in the frame of the body, from its centre of mass, unstrained [m]
    Vec3 place{};         ///< where it is held [m]
    double stiffness{0};  ///< [N/m]; 0 = chosen by the solid method
};

/// A straight spring between points of two bodies, under tension and compression alike: a rock bolt.
struct Bolt {
    BodyId first, second;
    Vec3 first_point{}, second_point{};  ///< as FixedPoint::point [m]
    double stiffness{0};                 ///< [N/m]
    double rest_length{0};               ///< without force; shorter than the distance at the start = prestressed [m]
};

}  // namespace riprap::body
