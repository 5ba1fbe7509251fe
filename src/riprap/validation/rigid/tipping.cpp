// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/rigid/tipping.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81;

double weight(const StandingBlock& block) { return block.density * block.width * block.height * gravity; }

/// x of the strip at the limit [m]
/// @param load  N [N]
/// @param lean  tan(slope) or acceleration over gravity [-]
double strip(const StandingBlock& block, double load, double lean) {
    const double stiffness = block.stiffness / (0.5 * std::min({block.width, block.height, 1.0}));
    return std::cbrt(2 * block.height * (1 + lean * lean) * load / (9 * stiffness));
}

/// Solves b - h lean = 3 x(lean). The strip hardly depends on the lean: each turn gains two digits or more.
template <class Load>
double tipping_lean(const StandingBlock& block, Load load) {
    double lean = block.width / block.height;
    for (int i = 0; i < 50; ++i) {
        lean = (block.width - 3 * strip(block, load(lean), lean)) / block.height;
    }
    return lean;
}

double load_on_slope(const StandingBlock& block, double lean) { return weight(block) / std::sqrt(1 + lean * lean); }

}  // namespace

double tipping_slope(const StandingBlock& block) {
    return std::atan(tipping_lean(block, [&](double lean) { return load_on_slope(block, lean); }));
}

double tipping_acceleration(const StandingBlock& block) {
    return tipping_lean(block, [&](double) { return weight(block); });
}

double tipping_tilt(const StandingBlock& block) {
    const double lean = std::tan(tipping_slope(block));
    // 2 N/(9 K x^2) = x/H
    return strip(block, load_on_slope(block, lean), lean) / (block.height * (1 + lean * lean));
}

}  // namespace riprap::validation::rigid
