// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "riprap/core/vec3.hpp"

namespace riprap::coupling {

/// A body with sides in a pocket: v and omega take the room area . v + moment . omega of it in a second, and 1 Pa more
/// in the pocket gives the body force and torque, about -area and -moment.
struct PocketSide {
    std::int32_t body;
    Vec3 area{}, moment{};   ///< out of the body [m^2], about its centre [m^3]
    Vec3 force{}, torque{};  ///< along what guides leave free [N/Pa], [N m/Pa]
};

/// A pocket full of water beside free bodies: water that has no way out carries those that close it. Scratch, for a
/// step.
struct PressedPocket {
    std::size_t number;               ///< among the pockets of the grid
    double room;                      ///< [m^3]
    double excess;                    ///< of water over what there is room for [-]
    std::vector<std::size_t> facets;  ///< of bodies in it, numbers among those that were cut
    std::vector<PocketSide> sides;    ///< of bodies that forces may move
};

}  // namespace riprap::coupling
