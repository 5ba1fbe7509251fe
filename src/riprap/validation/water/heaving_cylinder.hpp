// SPDX-License-Identifier: Apache-2.0
#pragma once

// A circular cylinder that floats half immersed in deep water and heaves a little: linear theory.

#include <vector>

namespace riprap::validation::water {

/// What the water adds to m y'' + C y = 0 while the cylinder heaves at the frequency omega, per metre of its length.
struct HeaveLoads {
    double added_mass;  ///< over rho a^2 [-]
    double damping;     ///< over rho a^2 omega [-]
};

/// Loads of heave by the expansion of [Ursell1949]: with the wave number K = omega^2/g, r and theta from the middle of
/// the surface, theta from the downward vertical y, z = r exp(-i theta), all lengths over the radius a,
///
///     phi = q (Re(-exp(-K z) Ei(K z)) + i pi Re exp(-K z))
///           + sum_m p_m (cos(2 m theta)/r^(2 m) + K cos((2 m - 1) theta)/((2 m - 1) r^(2 m - 1)))
///
/// meets K phi + d phi/dy = 0 on the surface and sends waves outwards; q and p_m make d phi/dr = cos theta on the
/// cylinder at as many points as there are of them. Then A + i B/omega = -rho a^2 times the integral of phi cos theta
/// over it. Sixteen points give A to 0.1 % and B to 0.4 % where waves are made (K a < 2).
/// @param ka  K a, positive
HeaveLoads heave_loads(double ka);

/// How it comes to rest after it was held off its place and let go [MaskellUrsell1970]: in units of a, rho and g, with
/// s = i W, W = omega sqrt(a/g), M = pi/2 (half of the water's density) and C = 2,
///
///     y(t)/y(0) = (2/pi) integral over W > 0 of Re((s (M + A) + B) / (s^2 (M + A) + s B + C)) cos(W t).
class HeaveDecay {
 public:
    HeaveDecay();
    /// y(t)/y(0). @param time  t sqrt(g/a), up to 100 [-]
    double at(double time) const;

 private:
    std::vector<double> frequency_, response_;  ///< W; the real part above, times the width of its interval
};

}  // namespace riprap::validation::water
