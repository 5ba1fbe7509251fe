// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// Classes of concrete armour units of breakwaters. Proportions are those of the class, not of a patented unit.
enum class ArmourUnit : std::uint8_t {
    cube,
    tetrapod,   ///< four tapered legs at equal angles
    accropode,  ///< an upright cross with two noses
    dolos,      ///< two legs at right angles at the ends of a trunk
    core_loc,   ///< two parallel flukes at the ends of a trunk, a third across its middle
};

/// A unit as convex parts about the origin that touch in whole faces and nowhere overlap, so that their volumes and
/// moments add up to those of the unit, exactly.
/// @param nominal_diameter  D_n, edge of the cube of the same volume [m]
std::vector<Polyhedron> armour_unit(ArmourUnit unit, double nominal_diameter);

/// A unit of a planar scene as prisms, z from -1/2 to 1/2 [m]: a square, three tapered legs, a cross with noses, an H,
/// an H with a third fluke [Ding2021, ch. 6, names the first three].
/// @param nominal_diameter  side of the square of the same area [m]
std::vector<Polyhedron> planar_armour_unit(ArmourUnit unit, double nominal_diameter);

}  // namespace riprap::geometry
