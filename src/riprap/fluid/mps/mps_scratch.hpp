// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps/bodies_in_pressure.hpp"
#include "riprap/fluid/mps/mps_neighbours.hpp"
#include "riprap/fluid/mps/mps_step.hpp"
#include "riprap/fluid/particle/sweep.hpp"
#include "riprap/fluid/sph/symmetric.hpp"
#include "riprap/linear/block_csr.hpp"
#include "riprap/linear/incomplete_cholesky.hpp"

namespace riprap::fluid {

/// Buffers of a step, one entry per particle.
struct MpsScratchData {
    std::vector<Vec3> start_velocity;        ///< v_n [m/s]
    std::vector<Vec3> predicted;             ///< r** [m]
    std::vector<Vec3> predicted_walls;       ///< places of wall particles at the end of the step [m]
    std::vector<Vec3> viscous_force;         ///< [N]
    std::vector<double> approaching, share;  ///< of collisions
    std::vector<Vec3> collision;             ///< change of velocity [m/s]

    std::vector<double> density;           ///< n**/n_0 [-]
    std::vector<std::uint8_t> surface;     ///< p = 0
    std::vector<std::int32_t> unknown;     ///< number of a particle in the equation, -1 at the surface
    std::vector<std::int32_t> particle;    ///< and back
    std::vector<double> pressure;          ///< [Pa]
    std::vector<Vec3> pressure_force;      ///< [N]
    std::vector<double> ones, grip_share;  ///< constant fields of the sums

    mps::Neighbours fluid, walls;  ///< of fluid particles at r**
    linear::BlockCsr<1> matrix;
    linear::IncompleteCholesky<1> preconditioner{8192};
    linear::PcgScratch solver;
    std::vector<double> right, solution;
    mps::BodiesInPressure bodies;

    std::vector<double> wall_share, wall_mirrors, wall_given;  ///< as of weakly compressible MPS
    std::vector<double> wall_ones;
    std::vector<Vec3> wall_head, wall_start;  ///< rho_0 (g - a_w) [Pa/m], u_n + dt g [m/s]
    std::vector<double> wall_weight, wall_pressure;
    std::vector<Vec3> wall_moment, wall_velocity, wall_slope, wall_push, mirrored_velocity;
    std::vector<std::array<double, symmetric_numbers>> wall_spread;
    std::vector<Vec3> wall_viscous, wall_collision;  ///< [N]
    double cell_weight{0}, slope_factor{0};

    SweepScratch fluid_fluid;
    SweepScratch fluid_walls{SweepScratch::sharing_buffers(fluid_fluid)};
    SweepScratch walls_fluid{SweepScratch::sharing_buffers(fluid_fluid)};

    std::size_t bytes() const {
        return bytes_of(start_velocity, predicted, predicted_walls, viscous_force, approaching, share, collision,
                        density, surface, unknown, particle, pressure, pressure_force, ones, grip_share, right,
                        solution, wall_share, wall_mirrors, wall_given, wall_ones, wall_head, wall_start, wall_weight,
                        wall_pressure, wall_moment, wall_velocity, wall_slope, wall_push, mirrored_velocity,
                        wall_spread, wall_viscous, wall_collision) +
               fluid.bytes() + walls.bytes() + matrix.bytes() + bodies.bytes() + preconditioner.bytes() +
               solver.bytes() + fluid_fluid.bytes() + fluid_walls.bytes() + walls_fluid.bytes();
    }
};

namespace mps {

/// Makes `count` zeros of it.
template <class T>
void clear(std::vector<T>& sums, std::size_t count) {
    sums.resize(count);
    parallel::for_each(static_cast<std::int64_t>(count),
                       [&](std::int64_t i) { sums[static_cast<std::size_t>(i)] = T{}; });
}

}  // namespace mps

}  // namespace riprap::fluid
