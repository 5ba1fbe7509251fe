// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/contact_kinematics.hpp"
#include "riprap/contact/contact_physics.hpp"
#include "riprap/contact/contact_set.hpp"

namespace riprap::contact {

/// Mobility of a body at a point, acceleration per force: a = W f, W = I/m - [r]x J^-1 [r]x, r from centre of mass to
/// the point, n the contact normal. Zero for a body that forces do not move.
struct Mobility {
    double along;         ///< n . W n = 1/m + (r x n) . J^-1 (r x n) [1/kg]
    double trace;         ///< of W [1/kg]
    double along_square;  ///< n . W W n [1/kg^2]
    double square;        ///< trace of W W [1/kg^2]
    double twist;         ///< n . J^-1 n: turning about the normal [1/(kg m^2)]
};

Mobility mobility_at(const PairSide& side, const Vec3& point, const Vec3& n);

/// Returns the motion of the two bodies of a candidate at a point, with their effective masses there.
ContactKinematics kinematics_at(const Candidate& pair, const Vec3& point, const Mobility& a, const Mobility& b);

/// A contact as springs and dashpots between two points.
struct LinearContact {
    double normal_stiffness{0};   ///< K_n [N/m]
    double shear_stiffness{0};    ///< K_s [N/m]
    double torsion_stiffness{0};  ///< about the normal [N m]
    double normal_damping{0};     ///< [N s/m]
    double shear_damping{0};      ///< [N s/m]
    double torsion_damping{0};    ///< about the normal [N m s]
};

/// Fills the row's share in the stability of both bodies (docs/theory/time-step.md): with
///
///     k_i = largest eigenvalue of W_i [K_n n n^T + K_s (I - n n^T)], plus torsion stiffness times twist  [1/s^2]
///
/// and the same of the dashpots, body i gets k_i + sqrt(k_i k_j), a bound of the norms of its diagonal and off-diagonal
/// blocks. The eigenvalue is bound by the two traces of the matrix [Wolkowicz1980]: m + sqrt(2) s, m and s mean and
/// deviation of the eigenvalues; exact where the two smaller ones are equal.
void set_stability(const LinearContact& contact, const Mobility& a, const Mobility& b, ContactRow& row);

/// Largest step dt for which dt^2 omega_squared/4 + dt damping/2 <= 1 [s]; infinity for zeros. Dashpots use the
/// velocity before the kick, which takes dt/2 times their matrix off the identity that multiplies the acceleration.
double stable_step(double omega_squared, double damping);

}  // namespace riprap::contact
