// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "riprap/fluid/mps_operators/mps_choices.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap {
template <class S>
struct MethodKeys;  // core/key.hpp
}

namespace riprap::fluid {

class ParticleScheme;  // particle/particle_scheme.hpp
class MpsWeight;       // mps_operators/mps_weight.hpp
struct MpsLattice;     // mps_operators/mps_lattice.hpp

/// Gradient of pressure that moves particles: pair by pair in balance, or exact for linear pressures [Amaro2021, eq.
/// 18].
enum class MpsGradient : std::uint8_t { conservative, corrected };

/// Settings of semi-implicit MPS: Model. Twice the smoothing ratio is r_e/l_0, the spacing l_0; a tenth of the sound
/// speed is the fastest that the scene is expected to make water. ParticleState::density is that of a linear state
/// equation: how pressure, from which the next solve starts, is kept.
struct MpsSettings : ParticleSettings {
    static constexpr std::string_view method_name = "mps";
    static MethodKeys<MpsSettings> keys();
    MpsSettings();

    double kinematic_viscosity{1e-6};  ///< nu [m^2/s]
    double compressibility{1e-8};      ///< alpha_c [1/Pa], > 0
    double relaxation{0.01};           ///< gamma: share of an error of density that a step corrects [-]
    double divergence_share{1};        ///< of the divergence of u** in the source of pressure [-]; 0 as in the source
    double surface_density{0.97};      ///< beta: a surface has less than this share of n_0 [-]
    double surface_offset{0.2};        ///< and its neighbours' centre farther than this share of l_0 [-]
    double collision_distance{0.8};    ///< share of l_0 below which particles collide [-]; 0 = off
    double collision_ratio{0.2};       ///< speed of separation over that of approach [-]
    MpsGradient gradient{MpsGradient::conservative};
    MpsWeightLaw weight_law{MpsWeightLaw::smooth};
    MpsWallPressure wall_pressure{MpsWallPressure::averaged};
    double tolerance{1e-6};    ///< of the residual of the pressure equation [-]
    int max_iterations{1000};  ///< of its solver

    static bool averages_at_walls(const MpsSettings& settings) {
        return settings.wall_pressure == MpsWallPressure::averaged;
    }
    /// Its steps need not grow: each takes back a share of an error of density, however short it is.
    static constexpr SchemeTraits<MpsSettings> traits{.starts_slowly = false,
                                                      .takes_joints = [](const MpsSettings&) { return true; },
                                                      .takes_normals = &averages_at_walls};

    double support_ratio() const { return 2 * smoothing_ratio; }  ///< r_e/l_0 [-]
    double expected_speed() const { return 0.1 * sound_speed; }   ///< [m/s]
    MpsWeight weight() const;
    MpsLattice lattice() const;
};

/// Makes the scheme of these settings.
std::unique_ptr<ParticleScheme> make_scheme(const MpsSettings& settings);

}  // namespace riprap::fluid
