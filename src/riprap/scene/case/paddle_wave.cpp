// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/case/paddle_wave.hpp"

#include <fmt/format.h>

#include <numbers>

namespace riprap::scene {

std::string text_of(const PaddleWave& wave) {
    if (wave.height == 0) {
        return fmt::format("{}, in {:.4g} m of water", wave.kind, wave.depth);
    }
    const std::string shape = wave.length > 0
                                  ? fmt::format("{:.4g} s, {:.4g} m long (kd = {:.3g}), ", wave.period, wave.length,
                                                2 * std::numbers::pi / wave.length * wave.depth)
                                  : "";
    return fmt::format("{}, {:.4g} m high in {:.4g} m of water, {}{:.4g} m/s, stroke {:.4g} m", wave.kind, wave.height,
                       wave.depth, shape, wave.celerity, wave.stroke);
}

}  // namespace riprap::scene
