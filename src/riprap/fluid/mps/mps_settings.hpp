// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/fluid/mps/mps_lattice.hpp"
#include "riprap/fluid/mps/mps_weight.hpp"
#include "riprap/fluid/particle/domain.hpp"

namespace riprap::fluid {

/// Gradient of pressure that moves particles: pair by pair in balance, or exact for linear pressures [Amaro2021, eq.
/// 18].
enum class MpsGradient : std::uint8_t { conservative, corrected };

/// Settings of semi-implicit MPS: Model.
struct MpsSettings {
    double spacing{0};                 ///< l_0: distance of particles at the start [m]
    double support_ratio{2.1};         ///< r_e/l_0 [-]
    double rest_density{1000};         ///< rho_0 [kg/m^3]
    double particle_mass{0};           ///< rho_0 l_0^dimension [kg]; in 2D per metre of width [kg/m]
    double expected_speed{0};          ///< fastest that the scene makes water [m/s]; 2 sqrt(g H) in a dam break
    double kinematic_viscosity{1e-6};  ///< nu [m^2/s]
    double compressibility{1e-8};      ///< alpha_c [1/Pa], > 0
    double relaxation{0.01};           ///< gamma: share of an error of density that a step corrects [-]
    double divergence_share{1};        ///< of the divergence of u** in the source of pressure [-]; 0 as in the source
    double surface_density{0.97};      ///< beta: a surface has less than this share of n_0 [-]
    double surface_offset{0.2};        ///< and its neighbours' centre farther than this share of l_0 [-]
    double collision_distance{0.8};    ///< share of l_0 below which particles collide [-]; 0 = off
    double collision_ratio{0.2};       ///< speed of separation over that of approach [-]
    MpsGradient gradient{MpsGradient::conservative};
    double courant{0.2};             ///< share of l_0/v that a step may last [-]
    double tolerance{1e-6};          ///< of the residual of the pressure equation [-]
    int max_iterations{1000};        ///< of its solver
    bool is_plain{false};            ///< pair sums in double, one pair at a time: the oracle of the fast ones
    std::int64_t sort_interval{50};  ///< steps between sorts of the State by place
    Domain domain;

    double support_radius() const { return support_ratio * spacing; }
    MpsWeight weight() const { return {support_radius(), spacing}; }
    MpsLattice lattice() const { return mps_lattice(support_ratio, spacing, domain.dimension); }
    /// gamma/alpha_c: pressure over the share of compression that it keeps in equilibrium [Pa]
    double bulk_modulus() const { return relaxation / compressibility; }
};

// ParticleState::density is rho_0 (1 + p alpha_c/gamma): how pressure, from which the next solve starts, is kept.

/// p [Pa]
inline double pressure_of(const MpsSettings& settings, double density) {
    return settings.bulk_modulus() * (density / settings.rest_density - 1);
}
/// [kg/m^3]
inline double density_of(const MpsSettings& settings, double pressure) {
    return settings.rest_density * (1 + pressure / settings.bulk_modulus());
}

}  // namespace riprap::fluid
