// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/analysis/overtopping_volumes.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::wave {

double OvertoppingVolumes::largest() const {
    double most = 0;
    for (const OvertoppingWave& wave : waves) {
        most = std::max(most, wave.volume);
    }
    return most;
}

OvertoppingVolumes overtopping_volumes(std::span<const double> time, std::span<const double> flow, double apart) {
    OvertoppingVolumes found{{}, 0, 0, 0};
    const std::size_t n = std::min(time.size(), flow.size());
    found.duration = n > 1 ? time[n - 1] - time[0] : 0;
    bool was_over = false;
    for (std::size_t i = 1; i < n; ++i) {
        const double share = 0.5 * (flow[i] + flow[i - 1]) * (time[i] - time[i - 1]);
        if (!std::isfinite(share)) {
            continue;
        }
        const bool is_over = share > 0;
        const bool is_next = found.waves.empty() || time[i - 1] - found.waves.back().begin >= apart;
        if (is_over && !was_over && is_next) {
            found.waves.push_back({time[i - 1], 0});
        }
        was_over = is_over;
        (found.waves.empty() ? found.rest : found.waves.back().volume) += share;
        found.total += share;
    }
    for (const OvertoppingWave& wave : found.waves) {
        found.rest += wave.volume > 0 ? 0 : wave.volume;
    }
    std::erase_if(found.waves, [](const OvertoppingWave& wave) { return !(wave.volume > 0); });
    return found;
}

}  // namespace riprap::wave
