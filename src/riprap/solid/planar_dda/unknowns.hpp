// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "riprap/geometry/planar/planar_vector.hpp"

namespace riprap::solid::planar_dda {

using geometry::Vec2;

/// Six unknowns of one block in one step, (u0, v0, gamma0, exx, eyy, gxy): displacement of the centroid [m], rotation
/// about it [rad], strains [-]; gxy = du/dy + dv/dx is the engineering shear [Ding2021, eq. 3.1]. The same order serves
/// rates [m/s, rad/s, 1/s] and generalized forces [N, N m, N m].
using Unknowns = std::array<double, 6>;

/// A symmetric or general 6 x 6 block, row by row.
using Block6 = std::array<double, 36>;

/// T(r) D, the displacement at the offset r = (X, Y) from the centroid [Ding2021, eq. 3.3],
///
///     T = | 1 0 -Y  X 0 Y/2 |
///         | 0 1  X  0 Y X/2 |
inline Vec2 displacement_at(const Vec2& r, const Unknowns& d) {
    return {d[0] - r.y * d[2] + r.x * d[3] + 0.5 * r.y * d[5], d[1] + r.x * d[2] + r.y * d[4] + 0.5 * r.x * d[5]};
}

/// T(r)^T f, the generalized force of a force f at the offset r: force, torque and sym(f r^T).
inline Unknowns force_at(const Vec2& r, const Vec2& f) {
    return {f.x, f.y, r.x * f.y - r.y * f.x, r.x * f.x, r.y * f.y, 0.5 * (r.y * f.x + r.x * f.y)};
}

inline double dot(const Unknowns& a, const Unknowns& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4] + a[5] * b[5];
}

/// y += s a.
inline void add(Unknowns& y, double s, const Unknowns& a) {
    for (std::size_t i = 0; i < 6; ++i) {
        y[i] += s * a[i];
    }
}

/// A += s a b^T.
inline void add_outer(Block6& A, double s, const Unknowns& a, const Unknowns& b) {
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            A[6 * i + j] += s * a[i] * b[j];
        }
    }
}

inline Unknowns multiply(const Block6& A, const Unknowns& x) {
    Unknowns y{};
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            y[i] += A[6 * i + j] * x[j];
        }
    }
    return y;
}

}  // namespace riprap::solid::planar_dda
