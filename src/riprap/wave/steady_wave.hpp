// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <vector>

namespace riprap::wave {

/// Velocity of water in the frame of the bed [m/s].
struct WaveVelocity {
    double along, up;
};

/// A steady wave of any height over a flat bed, to the precision of a Fourier series of the stream function
/// [Rienecker1981; Fenton1988]. In the frame of the crest, with x from the crest and y from the bed,
///
///     psi = -U y + sqrt(g/k^3) sum over j of B_j sinh(j k y)/cosh(j k d) cos(j k x),
///
/// where psi and the head are constant on the surface. One solver stands for Stokes' fifth order, cnoidal theory and
/// the higher orders of the solitary wave. Good up to 95 % of the height at which the wave breaks.
struct SteadyWave {
    double height, depth, gravity;  ///< H, d below the mean level (below the trough for a solitary wave) [m], [m/s^2]
    double wave_number;             ///< k [rad/m]
    double celerity;                ///< c [m/s]
    double mean_speed;              ///< U [m/s]
    std::vector<double> flow;       ///< B_1 .. B_N [-]
    std::vector<double> surface;    ///< cosine coefficients of the surface above the bed, 0 .. N [m]
    double reach;                   ///< beyond this distance from the crest there is nothing; infinite if periodic [m]

    /// Surface above d at a distance from the crest [m].
    double elevation(double from_crest) const;
    /// Velocity at a height above the bed, not above the surface; mean over time zero below the troughs.
    WaveVelocity velocity(double from_crest, double above_bed) const;
    double length() const;
};

/// A height or period that no steady wave has, with the number that would do.
class NoSuchWave : public std::domain_error {
    using std::domain_error::domain_error;
};

/// The regular wave of given height and period without a mean current below the troughs. @throws NoSuchWave
/// @param order  terms N of the series
SteadyWave regular_wave(double height, double period, double depth, double gravity, int order = 18);

/// The solitary wave of given height over the undisturbed depth: a periodic one of 24 depths, or more for low waves,
/// whose trough lies at d. Holds at H/d = 0.6, where first-order theory sheds a tail. @throws NoSuchWave above H/d =
/// 0.75
SteadyWave solitary_wave(double height, double depth, double gravity, int order = 56);

}  // namespace riprap::wave
