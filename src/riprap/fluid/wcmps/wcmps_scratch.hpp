// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep.hpp"
#include "riprap/fluid/sph/symmetric.hpp"
#include "riprap/fluid/wcmps/wcmps_step.hpp"

namespace riprap::fluid {

/// Buffers of a step, one entry per particle; see wcmps/pair_sums.hpp for the sums.
struct WcmpsScratchData {
    std::vector<double> concentration;                          ///< x = n/n_0 [-]
    std::vector<double> pressure, pressure_over_concentration;  ///< p and q = p/x [Pa]

    std::vector<double> rate, diffusion;  ///< sums of NumberContinuity
    std::vector<double> crowding;         ///< its sum W, then C = sum W/n_0, walls included [-]
    std::vector<double> neighbours;       ///< walls included [-]
    std::vector<Vec3> normal;             ///< its sum W d/r, then the outward unit normal [-]

    std::vector<Vec3> force;              ///< sums of MpsMomentum, then on the particle [N]
    std::vector<double> heat, wall_heat;  ///< of viscosity; the first counts each pair twice [W]
    std::vector<Vec3> crowding_gradient;  ///< grad C [1/m]
    std::vector<double> in_front;         ///< neighbours in the region in front of a particle
    std::vector<Vec3> wall_hold;          ///< minus the part of the force that is due to p_w, and
    std::vector<double> wall_hold_power;  ///< its power on the walls

    std::vector<SurfaceClass> surface;
    std::vector<double> is_surface;             ///< 1 in class F
    std::vector<Vec3> surface_normal;           ///< n in class F, else 0
    std::vector<double> adjacent, approaching;  ///< sums of MpsSurface
    std::vector<Vec3> inner_normal;             ///< its sum f_j n_j W
    std::vector<double> collision_share;        ///< s of MpsCollision
    std::vector<Vec3> collision;                ///< change of velocity [m/s]

    std::vector<double> wall_share;                  ///< b = V/l_0^D
    std::vector<double> wall_mirrors;                ///< m: 0 where a pressure is given, else 1
    std::vector<double> wall_given;                  ///< P: that pressure, else 0 [Pa]
    std::vector<Vec3> wall_head;                     ///< h = m rho_0 (g - a_w) [Pa/m]
    std::vector<double> wall_weight, wall_pressure;  ///< sums of MpsWallAverages
    std::vector<Vec3> wall_moment, wall_velocity;
    std::vector<Vec3> wall_slope, wall_push;  ///< sums of MpsPressureOnWalls
    std::vector<std::array<double, symmetric_numbers>> wall_spread;
    std::vector<Vec3> mirrored_velocity;  ///< u_w [m/s]
    std::vector<double> grip;             ///< 0 on slippery walls, else 1
    double cell_weight{0};                ///< 1/(n_0 l_0^D), as of the last sums at walls [1/m^3]
    double slope_factor{0};               ///< D/n_0, likewise [-]

    SweepScratch fluid_fluid;
    SweepScratch fluid_walls{SweepScratch::sharing_buffers(fluid_fluid)};
    SweepScratch walls_fluid{SweepScratch::sharing_buffers(fluid_fluid)};

    std::size_t bytes() const {
        return bytes_of(concentration, pressure, pressure_over_concentration, rate, diffusion, crowding, neighbours,
                        normal, force, heat, wall_heat, crowding_gradient, in_front, wall_hold, wall_hold_power,
                        surface, is_surface, surface_normal, adjacent, approaching, inner_normal, collision_share,
                        collision, wall_share, wall_mirrors, wall_given, wall_head, wall_weight, wall_pressure,
                        wall_moment, wall_velocity, wall_slope, wall_push, wall_spread, mirrored_velocity, grip) +
               fluid_fluid.bytes() + fluid_walls.bytes() + walls_fluid.bytes();
    }
};

/// Makes `count` zeros of it.
template <class T>
void clear(std::vector<T>& sums, std::size_t count) {
    sums.resize(count);
    parallel::for_each(static_cast<std::int64_t>(count),
                       [&](std::int64_t i) { sums[static_cast<std::size_t>(i)] = T{}; });
}

}  // namespace riprap::fluid
