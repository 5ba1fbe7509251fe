// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <numbers>
#include <span>
#include <vector>

#include "riprap/wave/irregular_wave.hpp"
#include "riprap/wave/wave_maker.hpp"

namespace riprap::wave {

/// 8 pi^2/3: H L^2 / d^3 from which on the crests of second-order waves are double [-].
inline constexpr double second_order_limit = 8 * std::numbers::pi * std::numbers::pi / 3;

/// One frequency of the stroke of a piston: x = Re(amplitude exp(i omega t)).
struct StrokeHarmonic {
    std::complex<double> amplitude;  ///< [m]
    double angular_frequency;        ///< > 0 [rad/s]
};

/// Stroke of a piston that makes a sea by linear theory [Dean1991, ch. 6]: X_n = a_n/(i c_n), c_n =
/// height_over_stroke.
std::vector<StrokeHarmonic> first_order_stroke(const IrregularWave& sea);

/// Second-order part of the stroke, which suppresses free waves at the sums and differences of the frequencies; bound
/// waves go with the sea by themselves. The potential to second order of all pairs of progressive
/// and evanescent modes is projected on the progressive mode of the pair's frequency, as in [Schaffer1996]. With W =
/// w_n +- w_m, W^2 = g K0 tanh K0 d, modes k_j of w_n and k_l of w_m (imaginary ones evanescent; for a difference those
/// of w_m are -k_l* and -w_m), K = k_j + k_l and amplitudes a_j = i X c_j, c_j = 4 sinh^2 k_j d/(2 k_j d + sinh 2 k_j
/// d),
///
///     X_2 = -i K0^2/W^3 1/2 sum over both orders of (sum_l -i g X_n a_l k_l^2/w_m (w_m^2 - W^2)/(k_l^2 - K0^2)
///                                                    + sum_jl -i K R_jl/(K^2 - K0^2)),
///     R_jl = -i a_j a_l (W (g^2 k_j k_l/(w_n w_m) - w_n w_m) + g^2 k_l^2/w_m - w_m^3).
///
/// Without X_2 its long differences would run through a flume as free waves. The limit of X_2 in shallow water, for one
/// frequency, is second_harmonic_stroke. A mean (W = 0) is left out.
std::vector<StrokeHarmonic> second_order_stroke(const IrregularWave& sea, double gravity);

/// The sum of harmonics in rows `step` apart from 0 to beyond `end`, growing from rest over `ramp` as
/// (1 - cos(pi t/ramp))/2.
MotionSeries series_of(std::span<const StrokeHarmonic> stroke, double ramp, double step, double end);

}  // namespace riprap::wave
