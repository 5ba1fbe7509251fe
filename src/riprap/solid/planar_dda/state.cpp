// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/state.hpp"

#include <cmath>

#include "riprap/core/index.hpp"

namespace riprap::solid::planar_dda {

Vec2 offset_of(const State& state, std::int32_t block, const Vec2& local) {
    const std::size_t b = at(block);
    const Vec2 stretched{state.stretch_xx[b] * local.x + state.stretch_xy[b] * local.y,
                         state.stretch_xy[b] * local.x + state.stretch_yy[b] * local.y};
    const double c = std::cos(state.angle[b]), s = std::sin(state.angle[b]);
    return {c * stretched.x - s * stretched.y, s * stretched.x + c * stretched.y};
}

Vec2 place_of(const State& state, std::int32_t block, const Vec2& local) {
    return Vec2{state.x[at(block)], state.y[at(block)]} + offset_of(state, block, local);
}

Unknowns rates_of(const State& state, std::int32_t block) {
    Unknowns rates;
    for (std::size_t k = 0; k < 6; ++k) {
        rates[k] = state.rates[6 * at(block) + k];
    }
    return rates;
}

Vec2 velocity_of(const State& state, std::int32_t block, const Vec2& local) {
    return displacement_at(offset_of(state, block, local), rates_of(state, block));
}

}  // namespace riprap::solid::planar_dda
