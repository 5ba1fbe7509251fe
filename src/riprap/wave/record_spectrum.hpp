// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/wave/irregular_wave.hpp"

namespace riprap::wave {

/// Spectral density of a record of the surface: the periodogram of its rows, laid out evenly by linear interpolation
/// and tapered at a tenth of either end, averaged over bands of `bands` frequencies 1/duration. Scaled to the variance
/// of the record. Rows that are not a number are left out. Empty for less than 16 rows.
/// @param time, elevation  equally long, time increasing [s], [m]
Spectrum spectrum_of(std::span<const double> time, std::span<const double> elevation, int bands);

/// Peak period of a spectrum by its fourth power, int S^4 df / int f S^4 df, which jumps less from record to record
/// than the largest density [Young1995] [s]; not a number for an empty one.
double weighted_peak_period(const Spectrum& spectrum);

/// Height that a share of the waves exceeds.
struct Exceedance {
    double share;   ///< [-]
    double height;  ///< [m]
};

/// Heights that 50, 20, 10, 5, 2 and 1 % of the waves exceed, as far as the record has waves for it: a share of p takes
/// 1/p waves.
std::vector<Exceedance> exceedances(std::vector<double> heights);

/// Water that goes through a gauge of flow, as over a crest.
struct Overtopping {
    double volume;        ///< through it over the record [m^3]; in 2D [m^2]
    double mean;          ///< over the duration [m^3/s]; in 2D [m^2/s]
    std::int64_t events;  ///< stretches with water going over
    double largest, at;   ///< volume of the largest event, and when it began [s]
};

/// Integrates a record of flow; what goes back counts as less.
Overtopping overtopping_of(std::span<const double> time, std::span<const double> flow);

}  // namespace riprap::wave
