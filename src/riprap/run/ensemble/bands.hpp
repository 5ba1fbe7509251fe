// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "riprap/io/csv.hpp"

namespace riprap::run {

/// Least, mean and largest of a column over all members, and the quantiles of 10, 50 and 90 %: x_k + s (x_k+1 - x_k)
/// of the n sorted values x_0 ... x_n-1 with k + s = p (n - 1), which is definition 7 of [HyndmanFan1996].
struct Band {
    io::CsvColumn column;
    std::vector<double> low, mean, high;
    std::vector<double> tenth{}, median{}, ninetieth{};
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

/// Writes `time`, then six columns for each band: NAME.low, NAME.mean, NAME.high, NAME.p10, NAME.p50, NAME.p90.
/// @throws FileError
void write_bands(const std::filesystem::path& path, const Bands& bands);

}  // namespace riprap::run
