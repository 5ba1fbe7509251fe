// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a coastal engineer reads from the gauges of a sea: reflection, heights, run-up, overtopping and forces, with
// bands of confidence, beside the formulas that they are held against.

#include <filesystem>
#include <string>
#include <vector>

#include "riprap/view/recorded_run.hpp"
#include "riprap/view/wave_report.hpp"
#include "riprap/wave/analysis/formulas.hpp"
#include "riprap/wave/analysis/overtopping_volumes.hpp"
#include "riprap/wave/analysis/sea_reflection.hpp"

namespace riprap::view {

struct SeaRequest {
    WaveRequest waves;
    int parts{5};                       ///< of equal length of the stretch of each run: samples of the bands
    std::vector<std::string> forces{};  ///< columns of probes.csv whose peaks are wanted
    wave::FormulaValues given{};        ///< inputs of formulas
};

/// One number, its band of 90 % by the parts of all runs, and what to know of it.
struct SeaNumber {
    std::string name, unit;
    double value, low, high;  ///< the band is not a number where there are fewer than two samples
    std::string note;         ///< empty: nothing
};

/// A formula beside the number of the run that it stands for.
struct FormulaRow {
    std::string name, quantity, unit, source, range;
    wave::Predicted predicted;
    double found;  ///< by the run; not a number where it does not record it
    bool is_in_range, has_band;
};

/// Volumes that one gauge of flow saw, run by run.
struct GaugeVolumes {
    std::string name;
    std::size_t run;
    wave::OvertoppingVolumes volumes;
};

struct SeaReport {
    double from, to;  ///< of the first run [s]
    std::size_t runs;
    int parts;
    std::vector<SeaNumber> numbers;
    wave::SeaReflection reflection;       ///< of the first run; empty where there is none
    std::vector<double> reflected_share;  ///< K_r over frequency, beside reflection.frequency
    std::vector<GaugeVolumes> volumes;
    std::vector<FormulaRow> formulas;
    std::vector<std::string> notices;
};

/// Analyses the gauges of one run, or of several that differ by their seeds. Levels: H_m0, T_m-1,0, H_1/3, H_2%, and
/// over two gauges or more along the waves incident and reflected sea (wave/analysis/sea_reflection.hpp); gauges of
/// kind run_up: R_u2% above the water line before the first wave; of kind flow: q, number and volumes of the waves that
/// go over; forces: F_max and F_1/250.
/// @throws BadRequest for a gauge or column that the runs do not have, or an input that no formula takes
SeaReport sea_report(const std::vector<RecordedRun>& runs, const SeaRequest& request);

/// For people, as one JSON object, and as files in a folder: sea.csv, sea_spectrum.csv, sea_volumes.csv, sea.svg.
std::string sea_text(const SeaReport& report);
std::string sea_json(const SeaReport& report);
std::vector<std::filesystem::path> write_sea(const std::filesystem::path& folder, const SeaReport& report);

}  // namespace riprap::view
