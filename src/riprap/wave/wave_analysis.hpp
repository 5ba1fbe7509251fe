// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

namespace riprap::wave {

/// One wave between two up-crossings of the mean level.
struct ZeroCrossingWave {
    double start;   ///< time of the first up-crossing [s]
    double period;  ///< [s]
    double height;  ///< crest to trough [m]
    double crest;   ///< above the mean level [m]
};

/// Cuts a record of the surface into waves at its up-crossings of the mean, found by linear interpolation. The part
/// before the first and after the last crossing is left out.
/// @param time, elevation  equally long, time increasing [s], [m]
std::vector<ZeroCrossingWave> zero_crossing_waves(std::span<const double> time, std::span<const double> elevation);

/// What a record of the surface is by its waves and by its variance. What needs a wave is not a number without one.
struct WaveStatistics {
    double mean_level;          ///< over time [m]
    std::int64_t count;         ///< of zero-crossing waves
    double mean_height;         ///< H_m [m]
    double significant_height;  ///< H_1/3, mean of the highest third of the waves, one at least [m]
    double highest;             ///< H_max [m]
    double mean_period;         ///< T_m [s]
    double significant_period;  ///< T_1/3, mean period of the highest third [s]
    double spectral_height;     ///< H_m0 = 4 sqrt(m_0), m_0 the variance over time [m]; of a sine 1.41 H
};

/// @param time, elevation  equally long, time increasing [s], [m]
WaveStatistics statistics_of(std::span<const double> time, std::span<const double> elevation);

/// Amplitude and phase of one frequency in a record: a in eta = mean + Re(a exp(-i omega t)), by least squares for
/// mean, cosine and sine, so that the record need not hold whole periods [m].
std::complex<double> harmonic(std::span<const double> time, std::span<const double> elevation,
                              double angular_frequency);

/// A regular wave train taken apart.
struct Separation {
    double incident;    ///< amplitude [m]
    double reflected;   ///< amplitude [m]
    double reflection;  ///< reflected / incident [-]
    double misfit;      ///< root mean square of what the two leave of the gauges' amplitudes / incident [-]; 0 for two
};

/// Splits a wave of one frequency into parts that run towards +x and -x by least squares over two or more gauges
/// [Mansard1980]: a_m = I exp(i k x_m) + R exp(-i k x_m).
/// @param place  of the gauges along x [m]; no two a multiple of half a wavelength apart, or the answer is empty noise:
///               incident is then not a number
/// @param amplitude  of each gauge, from harmonic() [m]
Separation separate_reflection(std::span<const double> place, std::span<const std::complex<double>> amplitude,
                               double wave_number);

}  // namespace riprap::wave
