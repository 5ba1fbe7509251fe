// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <vector>

#include "riprap/wave/irregular_wave.hpp"

namespace riprap::wave {

/// Answer of a piston to the surface that its own motion does not explain, eta_w, read at a distance x from its face:
///
///     a tau^2 u'' + tau u' + u = -G eta_w - h X,   a = absorption_bend,
///
/// X what the answers have moved it: it comes home with the rate h, so that an error of the mean level does not carry
/// it away. A wave of frequency w that comes to the face with amplitude 1 goes back with that of returned_by(),
///
///     R = 1 - (c/w) 2 F cos kx/(1 + F (c exp(-i k x) - i C)/w),   F = G/(1 + i w tau - a (w tau)^2 + h/(i w)),
///
/// c = height_over_stroke, C the evanescent modes of the piston at x. R = 0 takes F = (w/c)/(exp(i k x) + i C/c):
/// nearly sqrt(g/d), delayed by the way of the wave to the face and by the water that moves with the paddle. A delay of
/// first order returns short waves higher than they came, |R| > 1, whatever its length: between a wall and the paddle
/// they grow without end. One of second order does not.
struct AbsorptionLaw {
    double gain{0};      ///< G [1/s]
    double delay{0};     ///< tau [s]
    double home{0};      ///< h [1/s]
    double returned{0};  ///< share of the energy of the sea that goes back [-]
    double highest{0};   ///< largest |R| of the waves that the water can carry [-]
};

/// a: a step of the surface is followed with an overshoot of 12 % [-].
inline constexpr double absorption_bend = 0.8;

/// Largest |R| that does no harm: waves of ten spacings lose more than these 2 % to the viscosity of particles on any
/// way there and back [-].
inline constexpr double most_returned = 1.02;

/// A paddle in front of which the surface is read.
struct GaugedPaddle {
    double depth;     ///< d [m]
    double gravity;   ///< g [m/s^2]
    double distance;  ///< x from the face to the gauge [m]
};

/// R of a wave of one frequency.
std::complex<double> returned_by(const AbsorptionLaw& law, const GaugedPaddle& paddle, double angular_frequency);

/// The law that returns the least energy of a sea and no wave by more than `most_returned`, up to waves so short that k
/// x = `shortest`. `highest` is above that where there is none. @param home  h of the law [1/s]
AbsorptionLaw absorption_of_sea(const IrregularWave& sea, const GaugedPaddle& paddle, double home, double shortest);

/// The surface that a piston makes at the gauge by its own motion, first order: progressive and evanescent modes of all
/// frequencies.
class OwnSurface {
 public:
    OwnSurface() = default;
    OwnSurface(const IrregularWave& sea, const GaugedPaddle& paddle, double ramp);
    /// @param stroke  of the paddle from its place at rest by its own motion: progressive waves go by the place [m]
    double elevation(double time, double stroke) const;

 private:
    struct Mode {
        double angular_frequency, wave_number;
        std::complex<double> progressive, evanescent;  ///< at the gauge, the paddle at rest [m]
    };
    std::vector<Mode> modes_;
    double ramp_{0};
};

}  // namespace riprap::wave
