// SPDX-License-Identifier: Apache-2.0
#pragma once

// A circular cylinder that floats half immersed in deep water and heaves a little: linear theory.

#include <complex>
#include <vector>

namespace riprap::validation::water {

/// Terms that the water adds to m y'' + C y = 0 while the cylinder heaves at the frequency omega, per metre of its
/// length.
struct HeaveLoads {
    double added_mass;            ///< A(omega) over rho a^2 [-]
    double damping;               ///< B(omega) over rho a^2 omega [-]
    std::complex<double> source;  ///< q of the source below, for a heave of unit speed
};

/// Loads of heave by the expansion of [Ursell1949]. All lengths over the radius a, K = omega^2/g the wave number, r and
/// theta from the middle of the surface, theta from the downward vertical, z = r exp(-i theta); time goes as exp(-i
/// omega t) and the cylinder moves down with unit speed. The potential
///
///     phi = q (Re(-exp(-K z) Ei(K z)) + i pi Re exp(-K z))
///           + sum_m p_m (cos(2 m theta)/r^(2 m) + K cos((2 m - 1) theta)/((2 m - 1) r^(2 m - 1)))
///
/// with Ei(w) = gamma + ln w + sum w^n/(n n!) meets K phi + d phi/dy = 0 on the surface, and its first part is a
/// standing wave less another a quarter of a period later, which far away run outwards. q and p_m make d phi/dr = cos
/// theta at as many points of the cylinder, in the middle of equal arcs, as there are of them; Ursell asks the same of
/// the stream function. Then A + i B/omega = -rho a^2 times the integral of phi cos theta over it, and what the waves
/// carry away is B = pi^2 |q|^2 rho a^2 omega. With 64 points A and B are right to 0.1 % up to K a = 2.
/// @param ka  K a, above 0 and below 30: beyond, too few digits of Ei(K z) exp(-K z) are left
HeaveLoads heave_loads(double ka);

/// Decay of a cylinder that was held off its place and let go [MaskellUrsell1970]: in units of a, rho and g, with
/// W = omega sqrt(a/g), s = i W, M = pi/2 (half of the water's density) and C = 2,
///
///     y(t)/y(0) = (2/pi) integral over W > 0 of Re((s (M + A(W)) + B(W)) / (s^2 (M + A(W)) + s B(W) + C)) cos(W t).
///
/// W goes to 3.2 in steps of 0.01; what lies beyond is less than 1e-3 of y(0).
class HeaveDecay {
 public:
    HeaveDecay();
    /// y(t)/y(0). @param time  t sqrt(g/a), up to 100: after 200 pi the sum would begin anew [-]
    double at(double time) const;

 private:
    std::vector<double> frequency_, response_;  ///< W; the real part above, times the width of its interval
};

}  // namespace riprap::validation::water
