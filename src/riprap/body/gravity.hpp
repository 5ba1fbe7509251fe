// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "riprap/core/vec3.hpp"

namespace riprap::body {

/// Gravity as a function of time [m/s^2]: `value` scaled linearly from 0 to 1 over [0, ramp], then turned about
/// `axis` by rate * (t - start) for start <= t <= stop, or by an angle that is linear between given times and stays
/// before the first and after the last. A turned gravity replaces a tilted platform.
struct Gravity {
    Vec3 value{};                                          ///< [m/s^2]
    double ramp{0};                                        ///< [s]
    Vec3 axis{0, 0, 1};                                    ///< unit vector [-]
    double rate{0};                                        ///< [rad/s]
    double start{0};                                       ///< [s]
    double stop{std::numeric_limits<double>::infinity()};  ///< [s]
    std::vector<double> times{};                           ///< increasing, instead of `rate` [s]; empty: none
    std::vector<double> angles{};                          ///< at `times` [rad]
    bool turns() const { return rate != 0 || !times.empty(); }
    bool changes() const { return ramp > 0 || turns(); }  ///< with time
    double angle(double time) const;                      ///< of the turn [rad]
    Vec3 at(double time) const;
    /// Returns gravity that stays turned as it is at time 0.
    Gravity held() const;
};

}  // namespace riprap::body
