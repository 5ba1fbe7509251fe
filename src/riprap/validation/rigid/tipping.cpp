// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/rigid/tipping.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81;

/// x of the strip at the limit [m], for a block on this slope [rad]
double strip(const StandingBlock& block, double slope) {
    const double load = block.density * block.width * block.height * gravity * std::cos(slope);
    const double stiffness = block.stiffness / (0.5 * std::min({block.width, block.height, 1.0}));
    const double arm = block.height * (1 + std::tan(slope) * std::tan(slope));
    return std::cbrt(2 * arm * load / (9 * stiffness));
}

}  // namespace

double tipping_slope(const StandingBlock& block) {
    double slope = std::atan(block.width / block.height);
    for (int i = 0; i < 50; ++i) {  // the strip hardly depends on the slope: each turn gains two digits or more
        slope = std::atan((block.width - 3 * strip(block, slope)) / block.height);
    }
    return slope;
}

double tipping_tilt(const StandingBlock& block) {
    // N/(9 K x^2) = x/(2 H)
    const double slope = tipping_slope(block);
    return strip(block, slope) / (block.height * (1 + std::tan(slope) * std::tan(slope)));
}

}  // namespace riprap::validation::rigid
