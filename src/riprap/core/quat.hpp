// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/mat3.hpp"

namespace riprap {

/// Unit quaternion (w, x, y, z) that turns body coordinates into world coordinates.
struct Quat {
    double w{1}, x{0}, y{0}, z{0};

    friend constexpr bool operator==(const Quat&, const Quat&) = default;
};

/// Hamilton product: `a * b` turns by b first, then by a.
RIPRAP_HD constexpr Quat operator*(const Quat& a, const Quat& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
RIPRAP_HD constexpr Quat conjugate(const Quat& q) { return {q.w, -q.x, -q.y, -q.z}; }
RIPRAP_HD inline Quat normalized(const Quat& q) {
    const double s = 1 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return {s * q.w, s * q.x, s * q.y, s * q.z};
}
RIPRAP_HD constexpr Mat3 to_matrix(const Quat& q) {
    const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
    const double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
    const double wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
    return {{{1 - 2 * (yy + zz), 2 * (xy - wz), 2 * (xz + wy)},
             {2 * (xy + wz), 1 - 2 * (xx + zz), 2 * (yz - wx)},
             {2 * (xz - wy), 2 * (yz + wx), 1 - 2 * (xx + yy)}}};
}
/// q v q*: body to world.
RIPRAP_HD constexpr Vec3 rotate(const Quat& q, const Vec3& v) {
    const Vec3 u{q.x, q.y, q.z};
    const Vec3 t = 2.0 * cross(u, v);
    return v + q.w * t + cross(u, t);
}
/// q* v q: world to body.
RIPRAP_HD constexpr Vec3 rotate_back(const Quat& q, const Vec3& v) { return rotate(conjugate(q), v); }

/// exp(rotation/2): the turn about `rotation`/|rotation| by |rotation| [rad].
RIPRAP_HD inline Quat from_rotation_vector(const Vec3& rotation) {
    const double angle2 = norm_squared(rotation);
    const double angle = std::sqrt(angle2);
    // Series below 1e-3 rad: next terms are under 1e-19 relative.
    const double half_sinc = angle < 1e-3 ? 0.5 - angle2 / 48 + angle2 * angle2 / 3840 : std::sin(0.5 * angle) / angle;
    const double w = angle < 1e-3 ? 1 - angle2 / 8 + angle2 * angle2 / 384 : std::cos(0.5 * angle);
    return {w, half_sinc * rotation.x, half_sinc * rotation.y, half_sinc * rotation.z};
}
/// The rotation vector in (-pi, pi] of a unit quaternion; inverse of from_rotation_vector.
inline Vec3 to_rotation_vector(const Quat& q) {
    const double s = q.w < 0 ? -1 : 1;
    const Vec3 u{s * q.x, s * q.y, s * q.z};
    const double sine = norm(u);
    const double factor = sine < 1e-9 ? 2.0 : 2 * std::atan2(sine, s * q.w) / sine;
    return factor * u;
}
/// Quaternion of a proper rotation matrix.
Quat from_matrix(const Mat3& m);

/// Position and orientation of a body or a convex part: x_world = position + rotate(orientation, x_body).
struct Pose {
    Vec3 position{};
    Quat orientation{};
    friend constexpr bool operator==(const Pose&, const Pose&) = default;
};
RIPRAP_HD constexpr Vec3 to_world(const Pose& pose, const Vec3& x_body) {
    return pose.position + rotate(pose.orientation, x_body);
}
RIPRAP_HD constexpr Vec3 to_body(const Pose& pose, const Vec3& x_world) {
    return rotate_back(pose.orientation, x_world - pose.position);
}

}  // namespace riprap
