// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "riprap/view/recorded_run.hpp"

namespace riprap::view {

/// Waves as the case of a run states them.
struct CaseWaves {
    struct Place {
        std::string gauge;
        Vec3 point;
    };
    std::vector<Place> gauges;  ///< of kind level, and of kind surface along an upright line, in the order of the case
    std::vector<std::string> flows;       ///< of kind flow
    std::optional<Vec3> direction;        ///< of wave makers, where all agree
    std::optional<double> period, depth;  ///< of regular wave makers, where all agree [s], [m]
    std::string why_no_period;            ///< empty with one
};

/// Keys that are not as Riprap writes them count as missing.
CaseWaves waves_of_case(const RecordedRun& run);

}  // namespace riprap::view
