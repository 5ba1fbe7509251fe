// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "riprap/core/vec3.hpp"
#include "riprap/fluid/grid/mesh.hpp"

namespace riprap::fluid::grid {

struct Phase {
    double density;              ///< rho [kg/m^3]
    double kinematic_viscosity;  ///< nu [m^2/s]
};

/// Condition on one side of the domain.
enum class SideKind : std::uint8_t {
    slip,           ///< wall without friction
    no_slip,        ///< wall that the fluid sticks to
    wall_function,  ///< wall with the shear of a turbulent boundary layer (log law)
    open,           ///< pressure given: the atmosphere, free in- and outflow
    inflow,         ///< velocity and water fraction given by Side::inflow
};

/// Velocity and water fraction of what comes in.
struct Inflow {
    Vec3 velocity;          ///< [m/s]
    double fraction{1};     ///< of water [-]
    bool is_closed{false};  ///< a wall without friction here: nothing comes in
    bool is_drawn{false};   ///< the velocity leads out, and takes what is there
};

/// Lets long waves out through an inflow side: the normal velocity of wet cells gets sqrt(g/d) times what the surface
/// beside it stands above that of the water which comes in.
struct Absorber {
    bool is_on{false};
    int up{1};
    double depth{1};  ///< of still water at the side [m]
};

struct Side {
    SideKind kind{SideKind::slip};
    bool is_for_air{false};   ///< open for air alone: water that leaves is booked as let go
    Vec3 velocity{};          ///< of a wall, along itself [m/s]
    double open_fraction{0};  ///< water fraction of what comes in through an open side [-]
    double pressure{0};       ///< on an open side; at its still level where it has one [Pa]
    /// Says that what comes in through an open side was at rest far out: it has lost rho u^2/2 of that pressure, and
    /// brings no velocity along the side. Else it moves as what is inside does, which feeds vortices at the side.
    bool is_from_rest{true};
    /// Level along axis `up` of water at rest beyond an open side [m]; it comes in below the level, air above.
    std::optional<double> still_level{};
    int up{1};
    std::function<Inflow(const Vec3& place, double time)> inflow{};
    Absorber absorber{};
};

/// Whether a velocity across a side, 2 a for the low and 2 a + 1 for the high one of axis a, leads into the domain.
inline bool comes_in(int side, double u) { return side % 2 == 1 ? u < 0 : u > 0; }

enum class VofScheme : std::uint8_t {
    plic,         ///< geometric: planes in cells, split by directions [Weymouth2010]
    compressive,  ///< algebraic, artificial compression with limited fluxes [Ding2021, eq. 3.25]
};

/// Closure of the resistance of a porous medium, R = a + b |U| with the filter velocity U [Pa s/m^2].
enum class PorousClosure : std::uint8_t { ding, van_gent, engelund };

/// Stones that water flows through.
struct PorousMedium {
    double porosity{1};            ///< n = V_f/V [-]
    double grain_size{0.01};       ///< D_50 [m]
    double linear{50};             ///< mu_1 or alpha [-]
    double quadratic{2};           ///< mu_2 or beta [-]
    double added_mass{0.34};       ///< C_A; `ding` takes it as it is, the others 0.34 (1 - n)/n in its place [-]
    double keulegan_carpenter{0};  ///< K_C = T_o U_M/(n D_50); 0 = steady flow, without the factor 1 + 7.5/K_C [-]
    PorousClosure closure{PorousClosure::ding};
};
struct PorousZone {
    PorousMedium medium;
    std::function<bool(const Vec3& place)> holds;  ///< is asked at cell centres
};

/// Takes momentum out of what moves through a zone, so that waves die away: du/dt = -rate u.
struct Sponge {
    std::function<double(const Vec3& place)> rate;  ///< 0 outside [1/s]
};

enum class Turbulence : std::uint8_t {
    laminar,
    k_epsilon,         ///< standard, with density in the operators and a buoyancy sink
    k_epsilon_stable,  ///< eddy viscosity limited where the strain is that of a wave without vorticity [Larsen2018]
};

/// One grid of fluid: what a case says of it.
struct GridSettings {
    Mesh mesh;
    Phase water{1000, 1e-6}, air{1.2, 1.48e-5};
    bool has_surface{true};     ///< false: water alone fills the domain
    Vec3 gravity{0, -9.81, 0};  ///< [m/s^2]
    /// Acceleration of the frame added to gravity: of a tank that moves by a(t), -a(t) [m/s^2].
    std::function<Vec3(double time)> frame_acceleration{};
    double full_gravity{0};            ///< largest size of both together, where the second is given [m/s^2]
    double surface_tension{0};         ///< sigma [N/m]
    std::array<Side, 6> side{};        ///< low and high side of x, y, z
    std::vector<PorousZone> porous{};  ///< the last that holds a place counts
    std::vector<Sponge> sponges{};
    Turbulence turbulence{Turbulence::laminar};
    VofScheme vof{VofScheme::plic};
    double compression{1};     ///< C_alpha of the compressive scheme [-]
    int outer_corrections{1};  ///< passes over transport, momentum and pressure; 2 is second order in time [-]
    /// Pressures in a pass, each after the first with the explicit momentum of the mean velocity of both ends [-].
    int pressure_corrections{1};
    double courant{0.45};       ///< largest sum over axes of |u| dt/h, below 0.5 for bounded fractions [-]
    double longest_step{1e30};  ///< [s]
    double tolerance{1e-5};     ///< of the pressure equation: residual at its end over that at its start [-]
    int longest_solve{60};      ///< iterations of the pressure equation [-]
};

}  // namespace riprap::fluid::grid
