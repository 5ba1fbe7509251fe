// SPDX-License-Identifier: Apache-2.0
#pragma once

// The waves of a run, from what its gauges of the surface recorded.

#include <optional>
#include <string>
#include <vector>

#include "riprap/view/recorded_run.hpp"
#include "riprap/wave/wave_analysis.hpp"

namespace riprap::view {

/// What is asked for. What is not given comes from the case of the run.
struct WaveRequest {
    std::vector<std::string> gauges{};   ///< of kind level or surface; empty: all
    std::optional<double> from{}, to{};  ///< stretch of the record [s]; default: the second half of it
    std::optional<double> period{};      ///< of a regular wave to take apart [s]; default: that of the wave maker
    std::optional<double> depth{};       ///< of still water [m]; default: that of the wave maker
};

/// What one gauge saw.
struct GaugeWaves {
    std::string name;
    double place;  ///< along the waves [m]
    wave::WaveStatistics waves;
    std::complex<double> amplitude{};  ///< at the period of the wave maker, wave::harmonic [m]
};

/// A regular wave taken apart over all gauges.
struct Reflection {
    double period, depth, length;  ///< [s], [m], [m]
    wave::Separation parts;
};

struct WaveReport {
    double from, to;  ///< of what was looked at: whole periods where a period is known [s]
    std::vector<GaugeWaves> gauges;
    std::optional<double> period;
    std::optional<Reflection> reflection;
    std::string why_no_reflection;  ///< empty with one
};

/// Waves between up-crossings of every gauge; where a period is known its harmonic, and, over two gauges or more that
/// lie apart along the waves, incident and reflected wave (docs/theory/waves.md, analysis of records). The way of the
/// waves is that of the wave maker, +x without one.
/// @throws BadRequest  for a gauge that the run does not have, a stretch without rows, a period without a depth
WaveReport analyse_waves(const RecordedRun& run, const WaveRequest& request);

/// For people, and as one JSON object.
std::string wave_text(const WaveReport& report);
std::string wave_json(const WaveReport& report);

}  // namespace riprap::view
