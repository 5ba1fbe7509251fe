// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "riprap/io/csv.hpp"
#include "riprap/run/run_case.hpp"

namespace riprap::run {

struct EnsembleOptions {
    RunOptions run;  ///< `out` is the folder of the ensemble; member k lies in out/member-k
    std::int64_t members{0};
};

/// Least, mean and largest of a column over all members.
struct Band {
    io::CsvColumn column;
    std::vector<double> low, mean, high;
};

/// Bands of everything that the members record, at the times of the first one; between its rows a member counts by the
/// straight line, after its end it does not count.
struct Bands {
    std::vector<double> time;  ///< [s]
    std::vector<Band> bands;
    std::vector<std::string> left_out;  ///< members whose table cannot be read, and why
};

/// Bands of the tables probes.csv of these run folders; one without a table is a member that has not run.
Bands gather_bands(const std::vector<std::filesystem::path>& members);

/// Writes `time`, then three columns for each band: NAME.low, NAME.mean, NAME.high. @throws FileError
void write_bands(const std::filesystem::path& path, const Bands& bands);

/// Runs the members one after another, each a run folder of its own with its drawn values as overrides; what is there
/// already is continued, and a member that is finished is left alone. Writes ensemble.csv (member, values, exit code),
/// ensemble.json (the same as sweep.json has of a study) and bands.csv. A member that is refused is named, and the
/// others go on; where all draw what a key does not allow, nothing is written. Stops after the member that a signal
/// ends.
/// @returns the first exit code that is not zero, else 0
/// @throws FileError where a file in the folder is of another ensemble, or of the user's
int run_ensemble(const EnsembleOptions& options);

}  // namespace riprap::run
