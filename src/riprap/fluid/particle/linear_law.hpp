// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/config.hpp"
#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::fluid {

/// p(rho) for loops over particles: pressure_of with all that no particle changes worked out.
class PressureLaw {
 public:
    explicit PressureLaw(const ParticleSettings& s)
        : is_linear_(s.state_equation != StateEquation::tait),
          least_(s.state_equation == StateEquation::linear_without_tension ? s.rest_density : 0),
          stiffness_(s.rest_density * s.sound_speed * s.sound_speed),
          rest_density_(s.rest_density),
          exponent_(s.tait_exponent) {}
    RIPRAP_HD double operator()(double density) const {
        const double x = (density < least_ ? least_ : density) / rest_density_;  // what is no number stays none
        return is_linear_ ? stiffness_ * (x - 1) : stiffness_ / exponent_ * (power(x, exponent_) - 1);
    }

 private:
    bool is_linear_;
    double least_, stiffness_, rest_density_, exponent_;
};

}  // namespace riprap::fluid
