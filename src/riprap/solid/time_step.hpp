// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "riprap/body/body_set.hpp"
#include "riprap/material/material_set.hpp"

namespace riprap::solid {

/// The body that limits the step, and by how much.
struct DemTimeStep {
    double limit;  ///< [s]; infinity when no free body can touch another
    BodyId body;
    std::string reason;  ///< for the log
};

/// Stability bound of the explicit step before any contact is known (docs/theory/time-step.md): every
/// body is taken as covered by neighbours over its whole surface, and Gershgorin's theorem on the mass-scaled
/// stiffness bounds
///
///     omega_max^2 <= lambda (k_i/r_i + k_j/r_j) (1/m_i + 1/sqrt(m_i m_j)),
///
/// lambda the largest eigenvalue of sum_faces A_f [n n^T + s (I - n n^T)], s the largest k_s/k_n. The neighbour j is
/// tried as the body itself, the lightest free body, the stiffest free body (largest k/r) and the stiffest immovable
/// one. Dashpots, which use the velocity before the kick, leave sqrt(1 + z^2) - z of 2/omega_max, z = sqrt(N) xi with N
/// the number of faces where contacts are damped tangentially too, else 2. Two cubes of side a and modulus k_n in an
/// undamped frictionless lattice give dt = (a/2) sqrt(rho/k_n).
/// @param left_out  per body, empty for none: it meets others in another way
DemTimeStep time_step_bound(const body::BodySet& bodies, const geometry::ShapeSet& shapes,
                            const material::MaterialSet& materials, std::span<const std::uint8_t> left_out = {});

}  // namespace riprap::solid
