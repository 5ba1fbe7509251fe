// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "riprap/scene/case/case_build.hpp"
#include "riprap/wave/linear_wave.hpp"

namespace riprap::scene {

/// Refuses a wave so short or so long for its depth that its theory is lost in round-off, as those of a spectrum in
/// other units are; false with a problem. Waves are told short from long, also where k d is no finite number, by
/// omega sqrt(d/g), which is about 1 between them.
/// @param whose  " for a paddle", for the message
inline bool check_wave_length(CaseBuild& build, const SourcePlace& place, double height, double period, double depth,
                              std::string_view whose = "") {
    constexpr double least_kd = 1e-4, most_kd = 300;
    const double g = norm(build.model.gravity.value), kd = wave::linear_wave(height, period, depth, g).kd();
    if (kd >= least_kd && kd <= most_kd) {
        return true;
    }
    const bool is_short = period < 2 * std::numbers::pi * std::sqrt(depth / g);
    build.problem(place,
                  fmt::format("waves of {:.4g} s in {:.4g} m of water are too {}{}", period, depth,
                              is_short ? "short" : "long", whose),
                  fmt::format("a period with kd = 2 pi d/L from {:g} to {:g}", least_kd, most_kd));
    return false;
}

}  // namespace riprap::scene
