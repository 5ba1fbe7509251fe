// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::fluid {

/// p(rho) for loops over particles: as pressure_of, the linear equations without a call.
class PressureLaw {
 public:
    explicit PressureLaw(const ParticleSettings& s)
        : settings_(&s),
          is_linear_(s.state_equation != StateEquation::tait),
          least_(s.state_equation == StateEquation::linear_without_tension ? s.rest_density : 0),
          stiffness_(s.rest_density * s.sound_speed * s.sound_speed),
          rest_density_(s.rest_density) {}
    double operator()(double density) const {
        return is_linear_ ? stiffness_ * (std::max(density, least_) / rest_density_ - 1)
                          : pressure_of(*settings_, density);
    }

 private:
    const ParticleSettings* settings_;
    bool is_linear_;
    double least_, stiffness_, rest_density_;
};

}  // namespace riprap::fluid
