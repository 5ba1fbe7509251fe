// SPDX-License-Identifier: Apache-2.0
#pragma once

// A sea in front of a structure taken apart into what comes and what goes back.

#include <span>
#include <string>
#include <vector>

#include "riprap/wave/analysis/even_record.hpp"

namespace riprap::wave {

/// Records of the surface at gauges along the waves, at the same times.
struct SeaRecord {
    std::vector<double> time;                 ///< increasing [s]
    std::vector<double> place;                ///< of the gauges along the waves [m]
    std::vector<std::vector<double>> levels;  ///< of each gauge [m]
    double depth, gravity;                    ///< of still water [m], [m/s^2]
};

/// Frequencies at which the gauges cannot tell the two ways apart, from `low` to `high` [1/s].
struct BlindBand {
    double low, high;
    double length;  ///< of waves in the middle of it [m]
    double share;   ///< of the energy of the sea, as the gauges see it on average [-]
};

/// Spectra of both trains over bands of frequency, blind bands left out.
struct SeaReflection {
    std::vector<double> frequency, incident, reflected;  ///< [1/s], [m^2 s], [m^2 s]
    std::vector<BlindBand> blind;
    double low, high;                          ///< frequencies looked at [1/s]
    double incident_height, reflected_height;  ///< H_m0 = 4 sqrt(m_0) over all that are not blind [m]
    double coefficient;                        ///< K_r = sqrt(m_0 reflected / m_0 incident) to 1.8 f_p [-]
    double peak_period, energy_period;         ///< T_p and T_m-1,0 = m_-1/m_0 of the incident sea [s]
    double noise;                              ///< variance that neither train explains / m_0 of a gauge [-]
    double blind_share;                        ///< of the energy, in blind bands [-]
    EvenRecord incident_record;                ///< incident surface at the first gauge, ends cut [m]
    bool is_empty() const { return frequency.empty(); }
};

/// Splits a sea into trains that run towards +x and -x, at each frequency 1/duration by least squares over the gauges
/// [Mansard1980; ZeltSkjelbreia1992]: a_m = I exp(i k x_m) + R exp(-i k x_m), k by linear theory. With D = 1 - |sum
/// exp(2 i k x_m)|^2/n^2, a frequency is blind below D = 0.0955, the value of two gauges 0.05 or 0.45 wave lengths
/// apart [Goda1976]. What the trains leave over is noise of variance s^2 per gauge; it raises |I|^2 and |R|^2 by s^2/(n
/// D), which is taken off. Looked at are 0.5 to 4 peak frequencies, as far as there are four rows a period.
///
/// Differs from the source: equal weights, and noise taken off. Bound waves do not run as free ones do: at about twice
/// the peak frequency a part of them counts as reflected, so K_r is that of 0.5 to 1.8 peak frequencies; the heights
/// are of all.
/// @returns an empty one for fewer than two gauges with values, a record without waves, or where all frequencies are
/// blind
SeaReflection reflect_sea(const SeaRecord& record);

}  // namespace riprap::wave
