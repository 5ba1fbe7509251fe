// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace riprap::wave {

/// A record laid out evenly: row n at start + n step.
struct EvenRecord {
    double start, step;  ///< [s]
    std::vector<double> rows;
    double time(std::size_t row) const { return start + static_cast<double>(row) * step; }
};

/// Lays a record out in `count` rows from its first to its last time by cubic interpolation, which loses (omega
/// dt)^4/43 of an amplitude at most, where a straight line loses (omega dt)^2/8. Rows that are not a number are
/// bridged. Empty where fewer than two rows have a value.
/// @param time, values  equally long, time increasing [s]
EvenRecord even_record(std::span<const double> time, std::span<const double> values, std::size_t count);

/// Weight of a row that fades both ends of a record in and out by half a cosine.
/// @param share  of the rows that fade at either end
double fading(std::size_t row, std::size_t count, double share);

/// Takes off the mean and fades both ends in and out.
/// @returns the mean square of the weights: the variance of a faded record over that of the record [-]
double fade(EvenRecord& record, double share);

/// Complex amplitude a of one frequency, eta = Re(a exp(-i omega t)): 2/N sum of eta_n exp(i omega t_n).
std::complex<double> amplitude_of(const EvenRecord& record, double angular_frequency);

}  // namespace riprap::wave
