// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/steady_wave.hpp"

namespace riprap::wave {

/// A regular wave to the second order of Stokes [Dean1991, ch. 11], theta = k x - omega t, z above the bed:
///
///     eta = H/2 cos theta + k H^2/16 cosh kd (2 + cosh 2kd)/sinh^3 kd cos 2 theta,
///     u = omega H/2 cosh kz/sinh kd cos theta + 3/16 omega k H^2 cosh 2kz/sinh^4 kd cos 2 theta,
///     w = omega H/2 sinh kz/sinh kd sin theta + 3/16 omega k H^2 sinh 2kz/sinh^4 kd sin 2 theta.
///
/// Good while H L^2/d^3 < 8 pi^2/3, where a second crest would appear in the trough; steady_wave.hpp has all orders.
struct SecondOrderWave {
    LinearWave first;

    double elevation(double phase) const;  ///< above the still level [m]
    /// @param above_bed  z, up to the surface [m]
    WaveVelocity velocity(double phase, double above_bed) const;
};

/// The wave of given height and period. @throws NoSuchWave beyond the range of the theory
SecondOrderWave second_order_wave(double height, double period, double depth, double gravity);

}  // namespace riprap::wave
