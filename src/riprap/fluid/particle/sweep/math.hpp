// SPDX-License-Identifier: Apache-2.0
#pragma once

// The functions that pair physics may use besides + - * and comparison. Here for double and float, on host and device;
// core/wide.hpp has the same for numbers side by side. Call them without a namespace, from inside riprap::fluid.

#include <cmath>

#include "riprap/core/config.hpp"

namespace riprap::fluid {

RIPRAP_HD inline double min(double a, double b) { return a < b ? a : b; }
RIPRAP_HD inline float min(float a, float b) { return a < b ? a : b; }
RIPRAP_HD inline double max(double a, double b) { return a > b ? a : b; }
RIPRAP_HD inline float max(float a, float b) { return a > b ? a : b; }

/// a where the condition holds, else b. Both are evaluated, so both must be finite.
RIPRAP_HD inline double select(bool condition, double a, double b) { return condition ? a : b; }
RIPRAP_HD inline float select(bool condition, float a, float b) { return condition ? a : b; }

RIPRAP_HD inline double sqrt(double a) { return std::sqrt(a); }
RIPRAP_HD inline float sqrt(float a) { return std::sqrt(a); }

/// r from r^2 as a sweep hands it out: a square root that need not work at zero.
RIPRAP_HD inline double distance(double r2) { return std::sqrt(r2); }
RIPRAP_HD inline float distance(float r2) { return std::sqrt(r2); }

/// 1/a for a > 0. Lanes estimate and correct it: an error of 2 units in the last place, and cheaper than a division.
RIPRAP_HD inline double reciprocal(double a) { return 1 / a; }
RIPRAP_HD inline float reciprocal(float a) { return 1 / a; }

/// 1/sqrt(a) for a > 0, likewise.
RIPRAP_HD inline double reciprocal_sqrt(double a) { return 1 / std::sqrt(a); }
RIPRAP_HD inline float reciprocal_sqrt(float a) { return 1 / std::sqrt(a); }

}  // namespace riprap::fluid
