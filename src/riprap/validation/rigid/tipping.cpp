// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/rigid/tipping.hpp"

#include <algorithm>

namespace riprap::validation::rigid {

contact::ElasticFoot StandingBlock::foot() const {
    constexpr double gravity = 9.81;
    return {.width = width,
            .length = 1,
            .centre_height = 0.5 * height,
            .weight = density * width * height * gravity,
            .stiffness = stiffness / (0.5 * std::min({width, height, 1.0}))};
}

}  // namespace riprap::validation::rigid
