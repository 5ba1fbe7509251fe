// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "riprap/core/vec3.hpp"

namespace riprap::body {

/// Gravity as a function of time [m/s^2]: `value` scaled linearly from 0 to 1 over [0, ramp], then turned about
/// `axis` by rate * (t - start) for start <= t <= stop. A turned gravity replaces a tilted platform.
struct Gravity {
    Vec3 value{};                                          ///< [m/s^2]
    double ramp{0};                                        ///< [s]
    Vec3 axis{0, 0, 1};                                    ///< unit vector [-]
    double rate{0};                                        ///< [rad/s]
    double start{0};                                       ///< [s]
    double stop{std::numeric_limits<double>::infinity()};  ///< [s]
    Vec3 at(double time) const;
};

}  // namespace riprap::body
