// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/core/config.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"

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
};

/// Traits of a scheme, which its settings declare as `static constexpr SchemeTraits<Settings> traits{...}`. What they
/// leave out has the default; a name that is none of these does not compile.
template <class Settings>
struct SchemeTraits {
    bool books_every_step{false};  ///< all that is dissipated is booked in the step in which it is
    bool starts_slowly{true};      ///< the first steps after bodies were let go grow from little
    /// Sets what follows from the keys of a case, once they are read.
    void (*complete)(Settings&) = [](Settings&) {};
    /// Water may enter and leave; presses in joints between faces.
    bool (*takes_openings)(const Settings&) = [](const Settings&) { return false; };
    bool (*takes_joints)(const Settings&) = [](const Settings&) { return false; };
    /// The scheme reads BoundaryParticles::normal; outward_area.
    bool (*takes_normals)(const Settings&) = [](const Settings&) { return false; };
    bool (*takes_outward_area)(const Settings&) = [](const Settings&) { return false; };
};

}  // namespace riprap::fluid
