// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "riprap/solid/affine/blocks.hpp"

// Sub-matrices of three-dimensional DDA [Ding2021, chapter 4, corrected]. Unknowns of a block, in this order:
//
//     D = (u, v, w,  alpha, beta, gamma,  e_x, e_y, e_z,  g_xy, g_yz, g_zx),      u(x) = T(x) D,
//
// translation and rotation of the centroid, strains with engineering shears. With r = x - x_c
//
//         | 1 0 0   0  Z -Y   X 0 0  Y/2  0  Z/2 |
//     T = | 0 1 0  -Z  0  X   0 Y 0  X/2 Z/2  0  |
//         | 0 0 1   Y -X  0   0 0 Z   0  Y/2 X/2 |

namespace riprap::solid::implicit_dda {

inline constexpr int unknowns = 12;
using Vector12 = std::array<double, 12>;
using Matrix12 = std::array<double, 144>;  ///< by columns

/// T as its twelve columns.
using DisplacementMatrix = std::array<Vec3, 12>;
DisplacementMatrix displacement_matrix(const Vec3& arm);

/// T D
Vec3 displacement(const DisplacementMatrix& t, const double* d);
/// out += factor T^T f: what a force at a point does to the right-hand side [Ding2021, eq. 4.30].
void add_force(const DisplacementMatrix& t, const Vec3& f, double* out);

/// Displacement gradient G of the unknowns 4 to 12: T D = u + G r.
Mat3 gradient_of(const double* d);
/// The unknowns of translation u and gradient G.
Vector12 unknowns_of(const Vec3& translation, const Mat3& gradient);
/// T^T applied to a dipole sum of f r^T and a force: the right-hand side of loads given that way.
Vector12 load_vector(const Vec3& force, const Mat3& dipole);

/// J = rho integral of T^T T [Ding2021, eqs. 4.44-4.48] from mass and second moments S [kg m^2].
Matrix12 inertia_matrix(double mass, const Mat3& second_moments);
/// V E in the strain rows [Ding2021, eqs. 4.17-4.26, corrected: 1/((1 + nu)(1 - 2 nu))].
void add_elastic(const affine::Elasticity& material, double volume, Matrix12& k);
/// out -= V s0, the stress at the start of the step [Ding2021, eq. 4.28, corrected sign].
void add_initial_stress(const Mat3& stress, double volume, Vector12& out);

/// block += factor T_a^T N T_b, N the stiffness of a contact point, symmetric: k_n n n^T + k_s (1 - n n^T) where it is
/// locked [Ding2021, eqs. 4.63-4.86, corrected].
void add_springs(const DisplacementMatrix& a, const DisplacementMatrix& b, const Mat3& stiffness, double factor,
                 double* block);

/// y = A x
Vector12 times(const Matrix12& a, const Vector12& x);
inline double dot(const Vector12& a, const Vector12& b) {
    double sum = 0;
    for (std::size_t i = 0; i < 12; ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

}  // namespace riprap::solid::implicit_dda
