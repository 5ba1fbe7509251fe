// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "riprap/io/csv.hpp"

namespace riprap::run {

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

}  // namespace riprap::run
