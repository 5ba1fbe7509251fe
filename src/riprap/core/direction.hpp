// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "riprap/core/vec3.hpp"

namespace riprap {

/// Returns the unit vector along `v`, which is not zero, whatever its length: squares of components below 1e-154 or
/// above 1e154 would leave the range of a double.
inline Vec3 direction_of(const Vec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    const Vec3 scaled = v / largest;
    return largest > 1e-100 && largest < 1e100 ? normalized(v) : normalized(scaled);
}

}  // namespace riprap
