// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/settings.hpp"
#include "riprap/wave/steady_wave.hpp"

namespace riprap::fluid::grid {

/// Waves that come in through a side: surface above the still level and velocity there, over time [s].
struct IncomingWaves {
    std::function<double(double time)> elevation;                               ///< [m]
    std::function<wave::WaveVelocity(double above_bed, double time)> velocity;  ///< into the domain, up [m/s]
};

/// A side that gives waves: velocity and water fraction by theory in wet cells, in proportion to how wet they are, air
/// at rest above. With `absorbs`, waves that arrive at the side are let out: the normal velocity gets sqrt(g/d)
/// (measured - wanted elevation) towards the outside, which takes up long waves, kd < pi/10 (Side::absorber).
/// @param side  as in GridSettings::side
/// @param bed  place of the bed along `up` [m]
/// @param depth  of still water [m]
Side wave_side(const Mesh& mesh, int side, int up, double bed, double depth, IncomingWaves waves, bool absorbs);

/// A steady wave whose crest passes the side at `crest_time` [s].
IncomingWaves waves_of(const wave::SteadyWave& wave, double crest_time);

}  // namespace riprap::fluid::grid
