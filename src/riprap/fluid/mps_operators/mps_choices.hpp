// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace riprap::fluid {

/// Laws of the weight of moving particle methods, as a case names them (mps_weight.hpp).
enum class MpsWeightLaw : std::uint8_t { smooth, reciprocal };

/// Pressure of walls in the forces of moving particle methods (docs/theory/wcmps.md, 5): the mean of the water about
/// a wall particle, carried on as in still water; or that of each particle by itself, mirrored in the wall.
enum class MpsWallPressure : std::uint8_t { averaged, mirrored };

}  // namespace riprap::fluid
