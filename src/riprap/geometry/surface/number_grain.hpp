// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "riprap/geometry/surface/surface.hpp"

namespace riprap::geometry {

// Coordinates far from the origin lose digits where a file keeps seven: a point 5000 km away moves by a quarter metre.

/// Distance of a number in single precision from the next one; 0 where its last bits are zero, so that it was hardly
/// rounded.
double grain_of(float value);

/// Place value of the last digit of a number in scientific notation with five decimals or more ("5.10342e+06": 10),
/// as programs print those of single precision; 0 for others, and where that digit is 0.
double grain_of(std::string_view number);

/// Adds a note where the coordinates of a surface were rounded by more than 1e-4 of its edges (the median).
/// @throws CaseError where that is more than 2 %: areas and slopes would be wrong by several
void check_grain(Surface& surface);

}  // namespace riprap::geometry
