// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/core/config.hpp"
#include "riprap/fluid/particle/domain.hpp"

namespace riprap::fluid {

enum class StateEquation : std::uint8_t {
    tait,
    linear,
    linear_without_tension,  ///< nothing is stored and nothing pulls below the density at rest
};

/// Settings of any particle fluid: Model. Walls, openings, gauges and frames read this much; a scheme adds
/// its own.
struct ParticleSettings {
    double spacing{0};            ///< dp: distance of particles at the start [m]
    double smoothing_ratio{1.5};  ///< h/dp [-]; the kernel ends at 2 h
    double rest_density{1000};    ///< rho_0 [kg/m^3]
    double particle_mass{0};      ///< rho_0 dp^dimension [kg]; in 2D per metre of width [kg/m]
    double sound_speed{0};        ///< c_0 [m/s]
    StateEquation state_equation{StateEquation::tait};
    double tait_exponent{7};         ///< [-]
    double courant{0.8};             ///< share of h/(c + v) that a step may last [-]
    std::int64_t sort_interval{50};  ///< steps between sorts of the State by place
    Domain domain;
    bool is_plain{false};  ///< pair sums in double, one pair at a time: the oracle of the fast ones

    RIPRAP_HD double smoothing_length() const { return smoothing_ratio * spacing; }
    RIPRAP_HD double support_radius() const { return 2 * smoothing_length(); }

    // A scheme that can do more says so by a member of its own:
    bool takes_openings() const { return false; }      ///< water may enter and leave
    bool takes_joints() const { return false; }        ///< water presses in joints between faces
    bool takes_normals() const { return false; }       ///< the scheme reads BoundaryParticles::normal
    bool takes_outward_area() const { return false; }  ///< the scheme reads BoundaryParticles::outward_area
};

}  // namespace riprap::fluid
