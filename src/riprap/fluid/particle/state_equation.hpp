// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include "riprap/core/config.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"

namespace riprap::fluid {

// Pressure and energy of a weakly compressible fluid at density rho, x = rho/rho_0 [docs/theory/sph.md, 3]:
//
//     tait    p = rho_0 c_0^2/gamma (x^gamma - 1)      e = c_0^2/gamma ((x^(gamma-1) - 1)/(gamma-1) + 1/x - 1)
//     linear  p = rho_0 c_0^2 (x - 1)                  e = c_0^2 (ln x + 1/x - 1)
//
//     linear_without_tension  p = c_0^2 (rho - rho_0) where positive, else 0, and the e of `linear` likewise: that of
//             Mueller's scheme [Muller2003]
//
// where e = integral of p/rho^2 from rho_0, zero and least at rest. [Cole1948], [Monaghan1994]

/// x^exponent. Whole exponents by products, which is the case of water (7), the inner loop of a step and the same bits
/// on any device.
RIPRAP_HD inline double power(double x, double exponent) {
    if (exponent == std::floor(exponent) && exponent >= 0 && exponent <= 16) {
        double result = 1;
        for (int k = static_cast<int>(exponent); k > 0; k /= 2) {
            result *= k % 2 == 1 ? x : 1;
            x *= x;
        }
        return result;
    }
    return std::pow(x, exponent);
}

/// p [Pa] at density rho [kg/m^3].
double pressure_of(const ParticleSettings& settings, double density);
/// The density [kg/m^3] at which the pressure is p [Pa]; the least possible one where p is below that of empty space.
double density_of(const ParticleSettings& settings, double pressure);
/// e [J/kg] at density rho [kg/m^3].
double internal_energy_of(const ParticleSettings& settings, double density);
/// c = sqrt(dp/drho) [m/s]: c_0 x^((gamma-1)/2), or c_0.
double sound_speed_of(const ParticleSettings& settings, double density);

/// A numerical sound speed and where it comes from.
struct SoundSpeed {
    double value;        ///< c_0 [m/s]
    std::string reason;  ///< for the record
};

/// c_0 = 10 max(sqrt(|g| depth), max_speed): density then varies by about 1 % [Monaghan1994].
/// @param gravity    |g| [m/s^2]
/// @param depth      of the deepest water [m]
/// @param max_speed  the fastest that the scene itself makes water or solids move [m/s]; 2 sqrt(g H) in a dam break
SoundSpeed choose_sound_speed(double gravity, double depth, double max_speed);

}  // namespace riprap::fluid
