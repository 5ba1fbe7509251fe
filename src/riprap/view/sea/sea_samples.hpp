// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "riprap/view/sea/sea_report.hpp"

namespace riprap::view {

/// Names, units and values of one stretch of one run, in the order in which they are told.
struct SeaSample {
    struct Value {
        std::string name, unit;
        double value;
        std::string note;
    };
    std::vector<Value> values;
    wave::SeaReflection reflection;
    std::vector<std::pair<std::string, wave::OvertoppingVolumes>> volumes;
    double mean_period{0}, significant_period{0};  ///< of the incident waves, else of the first gauge [s]
    double waves{0};                               ///< number of them
    double highest{0};                             ///< H_1/250 [m]
};

/// What of a run an analysis looks at.
struct SeaGauges {
    std::vector<GaugeWaves> levels;  ///< names and places
    std::vector<GaugePlace> run_ups, flows;
    std::vector<std::string> forces;
    std::optional<double> depth;
};

/// Analyses one stretch. @throws FileError where the table is not that of the case
SeaSample sample_sea(const RecordedRun& run, const SeaGauges& gauges, double from, double to);

}  // namespace riprap::view
