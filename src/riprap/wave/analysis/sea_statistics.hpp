// SPDX-License-Identifier: Apache-2.0
#pragma once

// Numbers that an engineer reads from a record of a sea, and how sure they are.

#include <cstdint>
#include <span>
#include <vector>

namespace riprap::wave {

/// Least number of waves for a height that 2 % of them exceed: four of them do.
inline constexpr std::int64_t least_waves_for_2_percent = 200;

/// Mean of what `count` in `of` waves exceed: with 1 and 3 the significant height, with 1 and 250 Goda's force. Takes
/// one value at least; not a number without any.
double mean_of_highest(std::vector<double> values, double count, double of);

/// Value that a share of `of` waves exceeds, between the sorted values by rank share (of + 1), Weibull's place; not a
/// number where that is above the highest: share (of + 1) < 1.
/// @param of  number of waves, which may be more than there are values: waves that do not run up have none
double exceeded_by(std::vector<double> values, double share, double of);

/// T_m-1,0 = m_-1 / m_0 of the spectrum of a record between 0.5 and 4 peak frequencies [s]; not a number without waves.
double energy_period_of(std::span<const double> time, std::span<const double> elevation);

/// Mean of samples, and the band that holds the true mean with a probability of 90 %: mean -+ t s/sqrt(n), t Student's
/// of n - 1 degrees of freedom. Samples that are not a number are left out; the band is not a number for fewer than
/// two.
struct Confidence {
    double mean, low, high;
    std::int64_t samples;
};
Confidence confidence_of(std::span<const double> samples);

/// Largest values of a record between up-crossings of a level: one a wave that rises above it.
/// @param level  above which a rise counts
std::vector<double> peaks_above(std::span<const double> values, double level);

/// Largest values of a record, one in each period at most: a peak that follows a larger one within a period is not one.
std::vector<double> separate_peaks(std::span<const double> time, std::span<const double> values, double period);

}  // namespace riprap::wave
