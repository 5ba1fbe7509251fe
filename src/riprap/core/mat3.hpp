// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/vec3.hpp"

namespace riprap {

/// A 3x3 matrix stored by rows.
struct Mat3 {
    Vec3 row[3]{};

    RIPRAP_HD constexpr double& operator()(int i, int j) { return row[i][j]; }
    RIPRAP_HD constexpr double operator()(int i, int j) const { return row[i][j]; }
    friend constexpr bool operator==(const Mat3&, const Mat3&) = default;

    RIPRAP_HD static constexpr Mat3 identity() { return diagonal({1, 1, 1}); }
    RIPRAP_HD static constexpr Mat3 diagonal(const Vec3& d) { return {{{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z}}}; }
};

RIPRAP_HD constexpr Vec3 operator*(const Mat3& m, const Vec3& v) {
    return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)};
}
/// m^T v without forming the transpose.
RIPRAP_HD constexpr Vec3 transpose_times(const Mat3& m, const Vec3& v) {
    return v.x * m.row[0] + v.y * m.row[1] + v.z * m.row[2];
}
RIPRAP_HD constexpr Mat3 transpose(const Mat3& m) {
    return {{{m(0, 0), m(1, 0), m(2, 0)}, {m(0, 1), m(1, 1), m(2, 1)}, {m(0, 2), m(1, 2), m(2, 2)}}};
}
RIPRAP_HD constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
    return {{transpose_times(b, a.row[0]), transpose_times(b, a.row[1]), transpose_times(b, a.row[2])}};
}
RIPRAP_HD constexpr Mat3 operator+(const Mat3& a, const Mat3& b) {
    return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}};
}
RIPRAP_HD constexpr Mat3 operator-(const Mat3& a, const Mat3& b) {
    return {{a.row[0] - b.row[0], a.row[1] - b.row[1], a.row[2] - b.row[2]}};
}
RIPRAP_HD constexpr Mat3 operator*(double s, const Mat3& a) { return {{s * a.row[0], s * a.row[1], s * a.row[2]}}; }
/// The dyad a b^T.
RIPRAP_HD constexpr Mat3 outer(const Vec3& a, const Vec3& b) { return {{a.x * b, a.y * b, a.z * b}}; }
RIPRAP_HD constexpr double trace(const Mat3& m) { return m(0, 0) + m(1, 1) + m(2, 2); }
RIPRAP_HD constexpr double determinant(const Mat3& m) { return dot(m.row[0], cross(m.row[1], m.row[2])); }
/// Inverse by cofactors. The caller guarantees a non-zero determinant.
RIPRAP_HD constexpr Mat3 inverse(const Mat3& m) {
    const Vec3 a = cross(m.row[1], m.row[2]), b = cross(m.row[2], m.row[0]), c = cross(m.row[0], m.row[1]);
    return (1.0 / dot(m.row[0], a)) * transpose(Mat3{{a, b, c}});
}

/// Eigenvalues and right-handed orthonormal eigenvectors (columns of `axes`) of a symmetric matrix.
struct SymmetricEigen {
    Vec3 values;
    Mat3 axes;
};

/// Cyclic Jacobi rotations, to round-off. A matrix that is diagonal to 1e-14 of its largest entry
/// returns the identity as `axes`, so that blocks with principal axes along their own axes keep them.
SymmetricEigen symmetric_eigen(const Mat3& m);

}  // namespace riprap
