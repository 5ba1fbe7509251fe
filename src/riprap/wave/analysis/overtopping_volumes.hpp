// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace riprap::wave {

/// Water that one wave brings over a crest.
struct OvertoppingWave {
    double begin;   ///< when water begins to go over [s]
    double volume;  ///< [m^3] per metre, or as the flow is
};

/// Water over a crest, wave by wave.
struct OvertoppingVolumes {
    std::vector<OvertoppingWave> waves;
    double total;     ///< through the gauge, what goes back less [m^3]
    double duration;  ///< [s]
    double rest;      ///< of the total, before the first wave and in waves that bring nothing on balance [m^3]
    double largest() const;
};

/// Parts a record of flow at the moments at which water begins to go over, but not sooner after another than `apart`: a
/// wave that comes over in two tongues is one. The volume of a wave is all that goes through until the next one begins,
/// what flows back less, so that volumes and rest add up to the total.
/// @param time, flow  equally long, time increasing; rows without a value count as none [s], [m^3/s]
/// @param apart  half a mean period of the waves [s]
OvertoppingVolumes overtopping_volumes(std::span<const double> time, std::span<const double> flow, double apart);

}  // namespace riprap::wave
