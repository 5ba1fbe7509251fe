// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/analysis/goda_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/wave/linear_wave.hpp"

namespace riprap::wave {

GodaPressure goda_pressure(const GodaWall& wall) {
    constexpr double gravity = 9.81;
    const double kh = wall.depth * wave_number(2 * std::numbers::pi / wall.period, wall.depth, gravity);
    const double before = wall.depth + 5 * wall.significant * wall.foreshore, slant = std::cos(wall.angle);
    const double a1 = 0.6 + 0.5 * std::pow(2 * kh / std::sinh(2 * kh), 2);
    const double a2 =
        std::min((before - wall.depth_at_wall) / (3 * before) * std::pow(wall.highest / wall.depth_at_wall, 2),
                 2 * wall.depth_at_wall / wall.highest);
    const double a3 = 1 - wall.foot / wall.depth * (1 - 1 / std::cosh(kh));
    const double scale = 0.5 * (1 + slant) * wall.density * gravity * wall.highest;
    GodaPressure found{};
    found.reach = 0.75 * (1 + slant) * wall.highest;
    found.at_level = scale * (a1 + a2 * slant * slant);
    found.at_foot = a3 * found.at_level;
    found.at_crest = found.at_level * std::max(0.0, 1 - wall.crest / found.reach);
    found.uplift = scale * a1 * a3;
    found.force = 0.5 * (found.at_level + found.at_foot) * wall.foot +
                  0.5 * (found.at_level + found.at_crest) * std::min(found.reach, wall.crest);
    return found;
}

}  // namespace riprap::wave
