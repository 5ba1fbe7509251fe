// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/domain.hpp"

namespace riprap {
template <class S>
struct MethodKeys;  // core/key.hpp
}

namespace riprap::fluid {

enum class SphScheme : std::uint8_t { delta_sph, muller };
enum class StateEquation : std::uint8_t { tait, linear };
enum class Viscosity : std::uint8_t { artificial, laminar_sps };

/// What the case says of a particle fluid: Model. One set of defaults serves every case.
struct SphSettings {
    static constexpr std::string_view method_name = "sph";
    static MethodKeys<SphSettings> keys();

    SphScheme scheme{SphScheme::delta_sph};
    double spacing{0};            ///< dp: distance of particles at the start [m]
    double smoothing_ratio{1.5};  ///< h/dp [-]; the kernel ends at 2 h
    double rest_density{1000};    ///< rho_0 [kg/m^3]
    double particle_mass{0};      ///< rho_0 dp^dimension [kg]; in 2D per metre of width [kg/m]
    double sound_speed{0};        ///< c_0 [m/s]
    StateEquation state_equation{StateEquation::tait};
    double tait_exponent{7};  ///< [-]
    Viscosity viscosity{Viscosity::artificial};
    double artificial_alpha{0.02};     ///< [-]
    double kinematic_viscosity{1e-6};  ///< nu [m^2/s]
    double smagorinsky{0.12};          ///< C_s of the SPS model [-]
    double density_diffusion{0.1};     ///< delta [-]
    double acoustic_damping{1};        ///< a of the bulk viscosity that damps sound [-]; 0 = off
    double shifting{10};               ///< A of the particle shifting [-]; 0 = off
    bool gradient_correction{true};    ///< density follows the divergence inside the water
    double courant{0.8};               ///< share of h/(c + v) that a step may last [-]; see courant_bound
    bool is_plain{false};              ///< pair sums in double, one pair at a time: the oracle of the fast ones
    std::int64_t sort_interval{50};    ///< steps between sorts of the State by place
    Domain domain;

    double smoothing_length() const { return smoothing_ratio * spacing; }
    double support_radius() const { return 2 * smoothing_length(); }
};

}  // namespace riprap::fluid
