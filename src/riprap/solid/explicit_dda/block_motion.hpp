// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/affine/blocks.hpp"
#include "riprap/solid/explicit_dda/settings.hpp"

namespace riprap::solid::explicit_dda {

/// Force and dipole on one block at the mid-step pose.
struct BlockForce {
    Vec3 force{};   ///< [N]
    Mat3 dipole{};  ///< sum of f r^T, r from the centroid [N m]
};

/// Moves a block by its velocities over time h.
///
/// pseudo_rigid: x_c += v h, F += F' h with F' = L F [MikolaSitar2013, section 5, large-motion form].
/// twelve_unknowns: w h = turn, e = strain of h; F <- (exp[w h]x + e) F, stress <- R s R^T + C e, the strain rate turns
/// with the block, and the spin follows from the angular momentum, which is carried over: L_new = L_old.
/// A fixed block goes on with the velocity and spin it has.
void drift(const affine::BlockSystem& system, Form form, double h, std::int32_t block, affine::BlockState& state);

/// Changes the velocities of a free block by the loads over dt:
///
///     v += (f/m + g) dt,
///     pseudo_rigid:     F' += (M F^-T - V0 P(F)) E0^-1 dt,  P = F (lambda tr(e) I + 2 mu e),  e = (F^T F - I)/2,
///     twelve_unknowns:  L  += (M - V s) S^-1 dt,            S = F E0 F^T,
///
/// M the dipole. Writes the Cauchy stress of the present stretch to the state.
void kick(const affine::BlockSystem& system, Form form, const BlockForce& load, double dt, double mass_damping,
          std::int32_t block, affine::BlockState& state);

/// Elastic energy of a block at its present deformation or stress [J].
double strain_energy(const affine::BlockSystem& system, Form form, const affine::BlockState& state, std::int32_t block);

}  // namespace riprap::solid::explicit_dda
