// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/wave_side.hpp"

#include <algorithm>

namespace riprap::fluid::grid {

Side wave_side(const Mesh& mesh, int side, int up, double bed, double depth, IncomingWaves waves, bool absorbs) {
    const int axis = side / 2;
    const double inward = side % 2 == 0 ? 1 : -1;
    Side result;
    result.kind = SideKind::inflow;
    result.inflow = [edges = mesh.edge[at(up)], axis, up, bed, depth, inward, waves = std::move(waves)](
                        const Vec3& place, double time) {
        const double level = bed + depth + waves.elevation(time);
        const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, place[up]);
        const double low = *(above - 1), high = *above, wet = std::clamp((level - low) / (high - low), 0.0, 1.0);
        Inflow in{{}, wet};
        if (wet > 0) {
            const wave::WaveVelocity v = waves.velocity(std::clamp(place[up], bed, level) - bed, time);
            in.velocity[axis] = inward * wet * v.along;
            in.velocity[up] = wet * v.up;
        }
        return in;
    };
    if (absorbs) {
        result.absorber = {true, up, depth};
    }
    return result;
}

Side absorbing_side(const Mesh& mesh, int side, int up, double bed, double depth) {
    return wave_side(mesh, side, up, bed, depth,
                     {[](double) { return 0.0; },
                      [](double, double) {
                          return wave::WaveVelocity{0, 0};
                      }},
                     true);
}

IncomingWaves waves_of(const wave::SteadyWave& wave, double crest_time) {
    return {[wave, crest_time](double time) { return wave.elevation(wave.celerity * (crest_time - time)); },
            [wave, crest_time](double above_bed, double time) {
                return wave.velocity(wave.celerity * (crest_time - time), above_bed);
            }};
}

}  // namespace riprap::fluid::grid
