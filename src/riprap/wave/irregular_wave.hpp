// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/wave/steady_wave.hpp"

namespace riprap::wave {

/// Spectral density of the surface at a frequency f [m^2 s], JONSWAP [Hasselmann1973], scaled to the significant height
/// H_m0 = 4 sqrt(m_0); gamma = 1 is Pierson and Moskowitz':
///
///     S = A H_m0^2 f_p^4 f^-5 exp(-1.25 (f_p/f)^4) gamma^exp(-(f/f_p - 1)^2/(2 s^2)),  s = 0.07 to f_p, 0.09 above.
double jonswap_density(double frequency, double significant_height, double peak_period, double gamma);

/// A spectrum by points: linear between them, nothing beyond.
struct Spectrum {
    std::vector<double> frequency;  ///< rising [1/s]
    std::vector<double> density;    ///< S, one for each at least above 0 [m^2 s]

    double significant_height() const;  ///< H_m0 = 4 sqrt(m_0) [m]
    double peak_period() const;         ///< T_p, of the point with the largest density [s]
    bool is_empty() const { return frequency.empty(); }
};

/// Waves of many frequencies that add up, small against depth and length.
struct IrregularWave {
    struct Component {
        double amplitude, angular_frequency, wave_number, phase;
    };
    double depth;
    std::vector<Component> components;

    double elevation(double x, double time) const;  ///< [m]
    /// Velocity at a height above the bed; above the still level that of the still level.
    WaveVelocity velocity(double x, double above_bed, double time) const;
};

/// A sea of a JONSWAP spectrum between 0.5 and 3 peak frequencies, components of equal variance, phases drawn from
/// `seed`: the same sea on any machine. Its variance is exactly H_m0^2/16.
IrregularWave jonswap_sea(double significant_height, double peak_period, double gamma, double depth, double gravity,
                          int component_count, std::uint64_t seed);

/// A sea of any spectrum, likewise.
IrregularWave sea_of(const Spectrum& spectrum, double depth, double gravity, int component_count, std::uint64_t seed);

}  // namespace riprap::wave
