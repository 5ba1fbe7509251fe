// SPDX-License-Identifier: Apache-2.0
#pragma once

// The waves of a run, from what its gauges of the surface recorded.

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "riprap/view/recorded_run.hpp"
#include "riprap/wave/record_spectrum.hpp"
#include "riprap/wave/wave_analysis.hpp"

namespace riprap::view {

/// Request for an analysis of waves. Members that are not given come from the case of the run.
struct WaveRequest {
    std::vector<std::string> gauges{};   ///< of kind level or surface; empty: all
    std::optional<double> from{}, to{};  ///< stretch of the record [s]; default: the second half of it
    std::optional<double> period{};      ///< of a regular wave to take apart [s]; default: that of the wave maker
    std::optional<double> depth{};       ///< of still water [m]; default: that of the wave maker
    std::optional<Vec3> direction{};     ///< of the waves; default: that of the wave maker, or +x
};

/// Waves at one gauge.
struct GaugeWaves {
    std::string name;
    double place;                      ///< along the waves [m]
    wave::WaveStatistics waves;        ///< over the whole stretch
    std::int64_t missing;              ///< rows of the stretch without a value
    std::complex<double> amplitude{};  ///< at the period, over whole periods of the stretch, wave::harmonic [m]
    /// Highest value above the first [m], and when [s]; from `from` on, else of the whole run: a single wave may be
    /// over before the stretch begins.
    double rise{0}, rise_time{0};
    double peak_period{0};                     ///< T_p, wave::weighted_peak_period [s]
    std::vector<wave::Exceedance> exceeded{};  ///< by shares of the waves
};

/// Water through a gauge of flow.
struct GaugeFlow {
    std::string name;
    wave::Overtopping over;
};

/// A regular wave taken apart.
struct Reflection {
    double depth, length;             ///< [m]
    std::vector<std::string> gauges;  ///< over these
    wave::Separation parts;
};

struct WaveReport {
    double from, to;  ///< stretch looked at [s]
    std::vector<GaugeWaves> gauges;
    std::vector<GaugeFlow> flows;
    bool is_planar{false};         ///< flows are per metre of width
    std::optional<double> period;  ///< of the wave taken apart; none where rows are too far apart for it
    double whole_from{0};          ///< harmonics are over whole periods from here to the end [s]
    std::optional<Reflection> reflection;
    std::string why_no_reflection;  ///< empty with one
    std::vector<std::string> notices;
};

/// Waves between up-crossings of every gauge, the peak of its spectrum, what goes through gauges of flow; where a
/// period is known its harmonic, and, over two gauges or more that lie apart along the waves, incident and reflected
/// wave (docs/theory/waves.md, analysis of records). The report says why a wave was not taken apart.
/// @throws BadRequest  for a gauge that the run does not have, a stretch without rows, a number that cannot be meant
/// @throws FileError   where the tables of the run are not those of its case
WaveReport analyse_waves(const RecordedRun& run, const WaveRequest& request);

/// For people, and as one JSON object.
std::string wave_text(const WaveReport& report);
std::string wave_json(const WaveReport& report);

}  // namespace riprap::view
