// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

namespace riprap::scene {

/// Tells waves that are too short for their depth from those that are too long, also where k d is no finite number:
/// omega sqrt(d/g) is about 1 between them.
inline bool is_short_wave(double period, double depth, double gravity) {
    return period < 2 * std::numbers::pi * std::sqrt(depth / gravity);
}

}  // namespace riprap::scene
