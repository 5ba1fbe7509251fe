// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace riprap::bench {

/// Search for candidate pairs.
enum class Search { multilevel_grid, single_grid };

/// Processor time of one search [s], the median of several, for each number of bodies: bounding spheres at random in a
/// cube that they would half fill, every tenth one ten times the size of the others. On the calling thread's number of
/// host threads.
std::vector<double> search_times(Search search, std::span<const std::int32_t> counts);

/// d log t / d log n by least squares.
double log_log_slope(std::span<const std::int32_t> counts, std::span<const double> times);

}  // namespace riprap::bench
