// SPDX-License-Identifier: Apache-2.0
#pragma once

// Buffers of semi-implicit MPS, one entry per particle, grouped by the stage that writes them. Each group is made anew
// in every step; only the lists of neighbours are kept for speed.

#include <array>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/fluid/mps/bodies_in_pressure.hpp"
#include "riprap/fluid/mps/mps_neighbours.hpp"
#include "riprap/fluid/mps_operators/mps_lattice.hpp"
#include "riprap/fluid/mps_operators/mps_weight.hpp"
#include "riprap/fluid/mps_operators/wall_opening.hpp"
#include "riprap/fluid/particle/sweep/sweep_lists.hpp"
#include "riprap/fluid/particle/sweep/symmetric.hpp"
#include "riprap/linear/block_csr.hpp"
#include "riprap/linear/incomplete_cholesky.hpp"
#include "riprap/linear/pcg.hpp"

namespace riprap::fluid {

/// Fluid until the pressure: written by predict and collide, read by the kick.
struct MpsPrediction {
    std::vector<Vec3> start_velocity;  ///< v_n [m/s]
    std::vector<Vec3> viscous_force;   ///< [N]
    // For collisions:
    std::vector<double> approaching;  ///< neighbours that come nearer [-]
    std::vector<double> share;        ///< of the change that each of them gives [-]
    std::vector<Vec3> collision;      ///< change of velocity [m/s]

    std::size_t bytes() const { return bytes_of(start_velocity, viscous_force, approaching, share, collision); }
};

/// Walls as the water sees them: written by predict and collide, `head`, `start_velocity` and `openings` by
/// solve_pressure, `pressure` by load.
struct MpsWalls {
    std::vector<double> share;            ///< b, volume over that of a lattice place [-]
    std::vector<double> grip_share;       ///< the same, 0 on slippery walls [-]
    std::vector<double> follows;          ///< 1 = has the pressure of the water, 0 = has one of its own [-]
    std::vector<double> mirrors;          ///< m: 1 = that of each particle, mirrored, in forces and divergence [-]
    std::vector<double> given;            ///< P, of walls with a pressure of their own [Pa]
    std::vector<double> ones;             ///< a field of the sums, 1 everywhere
    std::vector<Vec3> mirrored_velocity;  ///< u_w [m/s]
    std::vector<Vec3> viscous_force, collision_force;  ///< on the walls [N]
    std::vector<Vec3> head;                            ///< rho_0 (g - a_w) [Pa/m]
    std::vector<Vec3> start_velocity;                  ///< u_n + dt g [m/s]
    MpsWallOpenings openings;                          ///< of r** and u**
    std::vector<double> pressure;                      ///< in forces where m = 0; P where it is given [Pa]

    std::size_t bytes() const {
        return bytes_of(share, grip_share, follows, mirrors, given, ones, mirrored_velocity, viscous_force,
                        collision_force, head, start_velocity, pressure) +
               openings.bytes();
    }
};

/// Sums over the water at every wall particle.
struct MpsAtWalls {
    std::vector<double> weight, pressure;  ///< of MpsWallAverages
    std::vector<Vec3> moment, velocity;
    std::vector<Vec3> slope;  ///< of SlopeAtWalls
    // At r**, for the loads: of PressureAtWalls, or where walls mirror each particle of MpsPressureOnWalls.
    std::vector<double> load_weight, load_pressure;
    std::vector<Vec3> load_moment, load_slope, load_push;
    std::vector<std::array<double, symmetric_numbers>> load_spread;  ///< sum of W/r^2 d d^T
    double cell_weight{0}, slope_factor{0};                          ///< from sums to WaterAtWalls

    std::size_t bytes() const {
        return bytes_of(weight, pressure, moment, velocity, slope, load_weight, load_pressure, load_moment, load_slope,
                        load_push, load_spread);
    }
};

/// Surroundings of the fluid particles at r**: written by set_up_pressure, read by all that follows.
struct MpsSurroundings {
    std::vector<Vec3> predicted;        ///< r** [m]
    std::vector<Vec3> predicted_walls;  ///< places of wall particles at the end of the step [m]
    mps::Neighbours fluid, walls;       ///< of every fluid particle
    std::vector<double> density;        ///< n**/n_0 [-]
    std::vector<std::uint8_t> surface;  ///< p = 0
    std::vector<double> ones;           ///< a field of the sums, 1 everywhere

    std::size_t bytes() const {
        return bytes_of(predicted, predicted_walls, density, surface, ones) + fluid.bytes() + walls.bytes();
    }
};

/// Pressure equation: written by set_up_pressure and solve_pressure.
struct MpsEquation {
    std::vector<std::int32_t> unknown;   ///< row of a particle, -1 at the surface
    std::vector<std::int32_t> particle;  ///< of a row
    linear::BlockCsr<1> matrix;
    linear::IncompleteCholesky<1> preconditioner{8192};
    linear::PcgScratch solver;
    std::vector<double> right, solution;

    std::size_t bytes() const {
        return bytes_of(unknown, particle, right, solution) + matrix.bytes() + preconditioner.bytes() + solver.bytes();
    }
};

/// Pressure and its force: the first is that of the State until solve_pressure, the second follows for the kick.
struct MpsWater {
    std::vector<double> pressure;      ///< [Pa]
    std::vector<Vec3> pressure_force;  ///< [N]

    std::size_t bytes() const { return bytes_of(pressure, pressure_force); }
};

/// All of them.
struct MpsScratch {
    MpsPrediction prediction;
    MpsWalls walls;
    MpsAtWalls at_walls;
    MpsSurroundings around;
    MpsEquation equation;
    MpsWater water;
    mps::BodiesInPressure bodies;
    SweepLists lists;

    std::size_t bytes() const {
        return prediction.bytes() + walls.bytes() + at_walls.bytes() + around.bytes() + equation.bytes() +
               water.bytes() + bodies.bytes() + lists.bytes();
    }
};

}  // namespace riprap::fluid
