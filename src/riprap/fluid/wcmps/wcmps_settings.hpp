// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "riprap/fluid/mps_operators/mps_choices.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"

namespace riprap {
template <class S>
struct MethodKeys;  // core/key.hpp
}

namespace riprap::fluid {

class ParticleScheme;  // particle/particle_scheme.hpp
class MpsWeight;       // mps_operators/mps_weight.hpp
struct MpsLattice;     // mps_operators/mps_lattice.hpp

/// Loads on solids: the exact reaction to what their particles do to the fluid, or pressure times area of the surface
/// particles along their normal [Mellado2021, eq. 5.40], which loses momentum.
enum class WallLoads : std::uint8_t { pair_sum, pressure_area };

/// Settings of weakly compressible MPS: Model. Twice the smoothing ratio is r_e/l_0, the spacing l_0.
struct WcmpsSettings : ParticleSettings {
    static constexpr std::string_view method_name = "wcmps";
    static MethodKeys<WcmpsSettings> keys();
    WcmpsSettings();

    double kinematic_viscosity{1e-6};  ///< nu [m^2/s]
    double density_diffusion{0.35};    ///< delta [-], 0 to 1
    double acoustic_damping{1};        ///< a, see wcmps::damp_sound [-]; 0 = off
    bool diffuses_hydrostatic{false};  ///< diffusion of all of n as in the source, not only of what gravity does not
                                       ///< explain; still water then creeps
    MpsWeightLaw weight_law{MpsWeightLaw::smooth};
    MpsWallPressure wall_pressure{MpsWallPressure::averaged};
    double shifting{1};              ///< multiple of the shift, see wcmps::shift [-]; 0 = off
    double collision_distance{0.9};  ///< share of l_0 below which surface particles collide [-]; 0 = off
    double collision_ratio{0.5};     ///< speed of separation over that of approach [-]
    WallLoads wall_loads{WallLoads::pair_sum};

    static bool averages_at_walls(const WcmpsSettings& settings) {
        return settings.wall_pressure == MpsWallPressure::averaged;
    }
    static bool presses_on_areas(const WcmpsSettings& settings) {
        return settings.wall_loads == WallLoads::pressure_area;
    }
    static constexpr SchemeTraits<WcmpsSettings> traits{.takes_joints = [](const WcmpsSettings&) { return true; },
                                                        .takes_normals = &averages_at_walls,
                                                        .takes_outward_area = &presses_on_areas};

    double support_ratio() const { return 2 * smoothing_ratio; }  ///< r_e/l_0 [-]
    MpsWeight weight() const;
    MpsLattice lattice() const;
};

/// Makes the scheme of these settings.
std::unique_ptr<ParticleScheme> make_scheme(const WcmpsSettings& settings);

// The state equation in the concentration x = n/n_0 = rho/rho_0 [Mellado2021, eq. 5.17]:
//
//     p = rho_0 c_0^2/gamma (x^gamma - 1),     e = c_0^2/gamma ((x^gamma - 1)/gamma - ln x),
//
// e = integral of p/(rho_0 x) from x = 1: the energy per mass that the operators conserve, whose m/rho_0 is the same
// for all particles (docs/theory/wcmps.md, 4).

/// p [Pa] at x = rho/rho_0
double pressure_of(const WcmpsSettings& settings, double concentration);
/// x at which the pressure is p [Pa] [Mellado2021, eq. 5.42]
double concentration_of(const WcmpsSettings& settings, double pressure);
/// e [J/kg]
double internal_energy_of(const WcmpsSettings& settings, double concentration);

}  // namespace riprap::fluid
