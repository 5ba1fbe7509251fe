// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/wave_side.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

namespace riprap::fluid::grid {

namespace {

/// Waves at one time, asked for once at each height: a wave of high order is a sum of many terms, and the cells beside
/// a side ask for it again and again in a step.
class KnownWaves {
 public:
    explicit KnownWaves(IncomingWaves waves) : waves_(std::move(waves)) {}
    double elevation(double time) {
        const std::lock_guard lock(guard_);
        go_to(time);
        return elevation_;
    }
    wave::WaveVelocity velocity(double above_bed, double time) {
        const std::lock_guard lock(guard_);
        go_to(time);
        const auto place = std::lower_bound(known_.begin(), known_.end(), above_bed,
                                            [](const Known& known, double height) { return known.height < height; });
        if (place != known_.end() && place->height == above_bed) {
            return place->velocity;
        }
        return known_.insert(place, {above_bed, waves_.velocity(above_bed, time)})->velocity;
    }

 private:
    struct Known {
        double height;  ///< above the bed [m]
        wave::WaveVelocity velocity;
    };
    void go_to(double time) {
        if (time != time_) {
            time_ = time;
            elevation_ = waves_.elevation(time);
            known_.clear();
        }
    }
    IncomingWaves waves_;
    std::mutex guard_;
    double time_{std::numeric_limits<double>::quiet_NaN()}, elevation_{0};
    std::vector<Known> known_;  ///< by height
};

}  // namespace

Side wave_side(const Mesh& mesh, int side, int up, double bed, double depth, IncomingWaves waves, bool absorbs) {
    const int axis = side / 2;
    const double inward = side % 2 == 0 ? 1 : -1;
    Side result;
    result.kind = SideKind::inflow;
    result.inflow = [edges = mesh.edge[at(up)], axis, up, bed, depth, inward,
                     waves = std::make_shared<KnownWaves>(std::move(waves))](const Vec3& place, double time) {
        const double level = bed + depth + waves->elevation(time);
        const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, place[up]);
        const double low = *(above - 1), high = *above, wet = std::clamp((level - low) / (high - low), 0.0, 1.0);
        Inflow in{{}, wet};
        if (wet > 0) {
            const wave::WaveVelocity v = waves->velocity(std::clamp(place[up], bed, level) - bed, time);
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

IncomingWaves waves_of(const wave::SteadyWave& wave, double crest_time) {
    return {[wave, crest_time](double time) { return wave.elevation(wave.celerity * (crest_time - time)); },
            [wave, crest_time](double above_bed, double time) {
                return wave.velocity(wave.celerity * (crest_time - time), above_bed);
            }};
}

}  // namespace riprap::fluid::grid
