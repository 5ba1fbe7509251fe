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

/// Cuts a record of the surface into waves at its up-crossings of the mean over time, found by linear interpolation.
/// The part before the first and after the last crossing is left out, and so is a wave with rows that are not a number.
/// @param time, elevation  equally long, time increasing [s], [m]
std::vector<ZeroCrossingWave> zero_crossing_waves(std::span<const double> time, std::span<const double> elevation);

/// Statistics of a record of the surface, by its waves and by its variance. Values that need a wave are not a number
/// without one.
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

/// Intervals with a row that is not a number count for no mean over time.
/// @param time, elevation  equally long, time increasing [s], [m]
WaveStatistics statistics_of(std::span<const double> time, std::span<const double> elevation);

/// Sums of a record of which amplitude and phase of one frequency follow, row by row: see harmonic().
struct HarmonicSums {
    double rows{0}, cosine{0}, sine{0}, cosine_square{0}, product{0}, sine_square{0};  ///< [-]
    double value{0}, with_cosine{0}, with_sine{0};                                     ///< [m]
    /// A row; one that is not a number is left out.
    /// @param angle  omega t [rad]
    void add(double angle, double elevation);
    std::complex<double> amplitude() const;
};

/// Amplitude and phase of one frequency in a record: a in eta = mean + Re(a exp(-i omega t)), by least squares for
/// mean, cosine and sine, so that the record need not hold whole periods; rows that are not a number are left out [m].
/// Not a number where the rows cannot tell the three apart: too few, or a multiple of half a period apart.
std::complex<double> harmonic(std::span<const double> time, std::span<const double> elevation,
                              double angular_frequency);

/// A regular wave train taken apart.
struct Separation {
    double incident;    ///< amplitude [m]
    double reflected;   ///< amplitude [m]
    double reflection;  ///< reflected / incident [-]
    double misfit;      ///< root mean square of the gauges' amplitudes less both trains / incident [-]; 0 for two
};

/// Splits a wave of one frequency into parts that run towards +x and -x by least squares over two or more gauges
/// [Mansard1980]: a_m = I exp(i k x_m) + R exp(-i k x_m). Gauges a multiple of half a wavelength apart cannot tell the
/// two: with D = 1 - |sum exp(2 i k x_m)|^2/n^2, sin^2(k dx) for two gauges, an error of the records comes out
/// 1/sqrt(D) times as large. Two gauges are good for dx of 0.05 to 0.45 wavelengths, or that and halves of it more
/// [Goda1976]: below the D of these, 0.095, the answer is not a number.
/// @param place  of the gauges along x [m]
/// @param amplitude  of each gauge, from harmonic() [m]
Separation separate_reflection(std::span<const double> place, std::span<const std::complex<double>> amplitude,
                               double wave_number);

}  // namespace riprap::wave
