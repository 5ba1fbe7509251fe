// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/mps/mps_scratch.hpp"

namespace riprap::fluid::mps {

/// Finds neighbours at r**, number density and surface, and fills the matrix of the pressure equation [Amaro2021, eqs.
/// 14, 15, 28, 29]:
///
///     A_ii = c sum_j W_ij + rho_0 alpha_c/dt^2,   A_ij = -c W_ij,   c = 2 D/(lambda n_0),
///
/// j over fluid; on the diagonal also over particles of the surface, whose p_j = 0. Walls mirror the pressure of i and
/// add to the right-hand side alone; walls of a given pressure add to the diagonal, too.
void set_up_pressure(const MpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls, double dt,
                     MpsScratchData& scratch);

/// Solves the pressure equation with the right-hand side
///
///     b_i = gamma rho_0/dt^2 (n**/n_0 + e_i - 1) - s rho_0/dt div u** + c rho_0 sum_w b_w W (g - a_w).(x_w - x_i) + c
///     sum_w b_w W p_given,
///
/// e the dilution of rest_density.hpp, starting from the pressures of the step before, which are in scratch. Pressures
/// below zero become zero.
linear::SolveReport solve_pressure(const MpsSettings& settings, const ParticleState& state,
                                   const BoundaryParticles& walls, const Vec3& gravity, double dt,
                                   MpsScratchData& scratch);

/// Computes pressure forces on particles [N] with the gradient that the settings choose.
void find_pressure_forces(const MpsSettings& settings, MpsScratchData& scratch);

}  // namespace riprap::fluid::mps
