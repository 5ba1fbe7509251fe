// SPDX-License-Identifier: Apache-2.0
// Which boxes float upright.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

void floating_stability(const CaseSetting& setting, CaseReport& report) {
    // Half as heavy as water a box floats upright from width/height = sqrt(6 s(1-s)) = 1.2247 on, s = 1/2.
    for (const double ratio : {1.10, 1.35}) {
        std::vector<std::string> box{fmt::format("body.box.shape={{box=[{:.3f},0.2]}}", 0.2 * ratio)};
        if (setting.is_full) {
            box.emplace_back("fluid.spacing=0.01");
        }
        WaterTrial trial(setting, box);
        trial.run();
        double largest = 0;
        for (const double angle : trial.column("box.rotation_vector.z")) {
            largest = std::max(largest, std::abs(angle * 180 / M_PI + 3));
        }
        const bool tips = ratio < std::sqrt(1.5);
        // Tips: leaves upright for good, that is by far more than it was set off it. Stands: stays nearer than twice
        // that.
        report.judge({fmt::format("width/height {}: largest angle off upright, let go at 3", ratio),
                      "deg",
                      {},
                      {},
                      tips ? "below 1.2247: tips" : "above 1.2247: stands"},
                     largest, tips ? 15 : 0, tips ? 180 : 6);
    }
}

}  // namespace riprap::validation::water
