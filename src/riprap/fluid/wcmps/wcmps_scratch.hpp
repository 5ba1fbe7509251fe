// SPDX-License-Identifier: Apache-2.0
#pragma once

// Buffers of WC-MPS, one entry per particle, grouped by the stage that writes them (sums: the headers of pairs). Each
// group is made anew in every step; only the lists of neighbours are kept for speed.

#include <array>
#include <cstdint>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/fluid/mps_operators/wall_opening.hpp"
#include "riprap/fluid/particle/sweep/numbers.hpp"
#include "riprap/fluid/particle/sweep/symmetric.hpp"

namespace riprap::fluid {

/// Where a particle lies relative to the free surface [JandaghianShakibaeinia2020].
enum class SurfaceClass : std::uint8_t {
    internal,  ///< I
    near,      ///< B: a particle of the surface within 2.1 l_0
    surface,   ///< F
    splash,    ///< E: C < 0.4
};

/// Follows from the density: read by all sums.
struct WcmpsWater {
    std::vector<double> concentration;                          ///< x = n/n_0 [-]
    std::vector<double> pressure, pressure_over_concentration;  ///< p and q = p/x [Pa]

    std::size_t bytes() const { return bytes_of(concentration, pressure, pressure_over_concentration); }
};

/// Sums of NumberContinuity and NumberContinuityAtWalls that the update of density alone reads: lent for the time of
/// it.
struct WcmpsDensitySums {
    NumbersView<1> diffusion;
    NumbersView<1> weight;    ///< sum W, walls included [-]
    NumbersView<1> standing;  ///< sum W of the water and of walls that stand still [-]
    NumbersView<1> stir;      ///< sum v^2 W [m^2/s^2]
    NumbersView<3> outward;   ///< sum W d/r, walls included [-]
    NumbersView<1> slip;      ///< sum b x g' W of walls [1/s]
    NumbersView<1> even;      ///< sum w of EvenCount, walls included [-]
};
inline WcmpsDensitySums lend_wcmps_density_sums(StageMemory<parallel::Host>& memory) {
    return {memory.lend<1>(0), memory.lend<1>(1), memory.lend<1>(2), memory.lend<1>(3),
            memory.lend<3>(4), memory.lend<1>(7), memory.lend<1>(8)};
}

/// Holds the sums that the update of density leaves to the stages after it.
struct WcmpsContinuity {
    std::vector<double> rate;        ///< sum of NumberContinuity
    std::vector<double> neighbours;  ///< likewise, walls included [-]
    std::vector<double> crowding;    ///< C = sum W/n_0 [-]
    std::vector<double> stir;        ///< u, how fast neighbours pass each other [m/s]
    std::vector<Vec3> normal;        ///< outward, of length 1 or 0 [-]
    std::vector<double> damped;      ///< s dx/dt/x of damp_sound [1/s]
    std::vector<double> slip;        ///< dx/dt/x by g' of walls [1/s]

    std::size_t bytes() const { return bytes_of(rate, neighbours, crowding, stir, normal, damped, slip); }
};

/// Sums of MpsMomentum and MpsMomentumFromWalls, lent from begin_forces to the kick: times l_0^D D/n_0 they are forces
/// [N] and powers [W], the gradient of crowding times D/n_0 is grad C [1/m].
struct WcmpsForceSums {
    NumbersView<3> force;
    NumbersView<1> heat, wall_heat;  ///< of viscosity; the first counts each pair twice
    NumbersView<3> crowding_gradient;
    NumbersView<1> in_front;                   ///< neighbours in the region in front of a particle
    NumbersView<3> wall_hold;                  ///< minus the part of the force that is due to p_w, and
    NumbersView<1> wall_hold_power;            ///< its power on the walls
    static constexpr std::size_t places = 13;  ///< more than WcmpsDensitySums take
};
inline WcmpsForceSums lend_wcmps_force_sums(StageMemory<parallel::Host>& memory) {
    return {memory.lend<3>(0), memory.lend<1>(3), memory.lend<1>(4), memory.lend<3>(5),
            memory.lend<1>(8), memory.lend<3>(9), memory.lend<1>(12)};
}

/// Surface as the last forces show it: read by collisions and shifting.
struct WcmpsSurface {
    std::vector<SurfaceClass> classes;
    std::vector<double> is_surface;   ///< 1 in class F
    std::vector<Vec3> normal;         ///< n in class F, else 0
    std::vector<double> adjacent;     ///< sum of MpsSurface
    std::vector<Vec3> inner_normal;   ///< its sum f_j n_j W
    std::vector<double> approaching;  ///< sum of MpsApproach

    std::size_t bytes() const { return bytes_of(classes, is_surface, normal, adjacent, approaching, inner_normal); }
};

struct WcmpsCollisions {
    std::vector<double> share;  ///< s of MpsCollision
    std::vector<Vec3> change;   ///< of velocity [m/s]

    std::size_t bytes() const { return bytes_of(share, change); }
};

/// Fields of wall particles that sums read: those of NumberContinuityAtWalls and MpsMomentumFromWalls.
struct WcmpsWalls {
    std::vector<double> share;            ///< b = V/l_0^D
    std::vector<std::uint8_t> is_given;   ///< has a pressure of its own
    std::vector<double> mirrors;          ///< m
    std::vector<double> stands_still;     ///< 1 where nothing moves it, else 0
    MpsWallOpenings openings;             ///< of the last density
    std::vector<double> averaged;         ///< A [Pa]
    std::vector<double> held;             ///< H [Pa]
    std::vector<Vec3> head;               ///< h [Pa/m]
    std::vector<Vec3> mirrored_velocity;  ///< u_w [m/s]
    std::vector<double> grip;             ///< 0 on slippery walls, else 1

    std::size_t bytes() const {
        return bytes_of(share, is_given, mirrors, stands_still, averaged, held, head, mirrored_velocity, grip) +
               openings.bytes();
    }
};

/// Sums over the water at wall particles, which do not depend on how the walls move.
struct WcmpsAtWalls {
    std::vector<double> weight, pressure;  ///< of MpsWallAverages
    std::vector<Vec3> moment, velocity;
    std::vector<Vec3> slope, push;  ///< of MpsPressureOnWalls
    std::vector<std::array<double, symmetric_numbers>> spread;
    double cell_weight{0};   ///< 1/(n_0 l_0^D), as of these sums [1/m^3]
    double slope_factor{0};  ///< D/n_0, likewise [-]

    std::size_t bytes() const { return bytes_of(weight, pressure, moment, velocity, slope, push, spread); }
};

}  // namespace riprap::fluid
