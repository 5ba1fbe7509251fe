// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/solitary_wave.hpp"

namespace riprap::wave {

/// Kind of a paddle.
enum class Paddle {
    piston,  ///< a plate that stays upright
    flap,    ///< a plate hinged at the bed; its stroke is that of the point at still water
};

/// Wave height over stroke far from a paddle, H/S [-] [Dean1991, ch. 6]:
///
///     piston  2 (cosh 2kd - 1) / (sinh 2kd + 2kd)
///     flap    4 (sinh kd / kd) (kd sinh kd - cosh kd + 1) / (sinh 2kd + 2kd)
double height_over_stroke(Paddle paddle, double kd);

/// A motion in time: value and its rate at increasing times, meant for cubic Hermite interpolation, so that value, rate
/// and (but for steps at the rows) acceleration follow the law.
struct MotionSeries {
    std::vector<double> time;   ///< [s]
    std::vector<double> value;  ///< stroke [m]
    std::vector<double> rate;   ///< [m/s]
};

/// The stroke of a paddle that makes regular waves: S/2 sin(wt) + S_2 sin(2wt).
struct RegularStroke {
    double first;   ///< S/2 [m]
    double second;  ///< S_2 [m]
};

/// Stroke of the second harmonic of a piston that cancels the free second harmonic [Madsen1971]:
///
///     x = S/2 sin(wt) + S_2 sin(2wt),   S_2 = H^2/(32 d) (3 cosh kd / sinh^3 kd - 2/m),   m = H/S of the piston.
///
/// Valid for H L^2 / d^3 < 8 pi^2/3 and, in practice, moderate steepness.
double second_harmonic_stroke(const LinearWave& wave);

/// S = H / height_over_stroke. `is_second_order`: suppress the free second harmonic; pistons only.
RegularStroke regular_stroke(const LinearWave& wave, Paddle paddle, bool is_second_order);

/// Elevation at x in front of a piston that its evanescent modes make, over its displacement X [-]: they stay at the
/// paddle and rise as it is displaced forward [Dean1991, ch. 6],
///
///     eta/X = sum_j 4 sin^2(k_j d)/(2 k_j d + sin 2 k_j d) exp(-k_j x),   omega^2 = -g k_j tan(k_j d).
///
/// @param x  from the face, > 0: at the face itself the sum falls like 1/j [m]
double evanescent_elevation(const LinearWave& wave, double x);

/// Motion of a piston that makes a solitary wave [Goring1978]: the paddle follows the mean velocity under the crest as
/// it passes,
///
///     dx/dt = c eta(x - c t) / (d + eta),   x = H/(K d) tanh(K (c t - x)) shifted to start at rest,
///
/// over the time tau = 2/(K c) (arctanh(0.999) + H/d), stroke 2 H/(K d).
MotionSeries solitary_motion(const SolitaryWave& wave);

}  // namespace riprap::wave
