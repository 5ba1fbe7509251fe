// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/wcmps/wcmps_settings.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/fluid/mps_operators/mps_lattice.hpp"
#include "riprap/fluid/mps_operators/mps_weight.hpp"

namespace riprap::fluid {
namespace {

/// x^exponent; by products for whole exponents, as water has
double power(double x, double exponent) {
    if (exponent == 7) {
        const double cube = x * x * x;
        return cube * cube * x;
    }
    return std::pow(x, exponent);
}

}  // namespace

WcmpsSettings::WcmpsSettings() {
    smoothing_ratio = 1.55;
    courant = 0.5;
}

MpsWeight WcmpsSettings::weight() const { return {support_radius(), spacing, weight_law}; }

MpsLattice WcmpsSettings::lattice() const {
    return mps_lattice(weight_law, support_ratio(), spacing, domain.dimension);
}

double pressure_of(const WcmpsSettings& s, double concentration) {
    const double stiffness = s.rest_density * s.sound_speed * s.sound_speed / s.tait_exponent;
    return stiffness * (power(concentration, s.tait_exponent) - 1);
}

double concentration_of(const WcmpsSettings& s, double pressure) {
    const double strain = s.tait_exponent * pressure / (s.rest_density * s.sound_speed * s.sound_speed);
    return std::pow(std::max(0.0, 1 + strain), 1 / s.tait_exponent);
}

double internal_energy_of(const WcmpsSettings& s, double concentration) {
    const double gamma = s.tait_exponent;
    return s.sound_speed * s.sound_speed / gamma *
           ((power(concentration, gamma) - 1) / gamma - std::log(concentration));
}

}  // namespace riprap::fluid
