// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/vec3.hpp"

namespace riprap {

/// A symmetric 3x3 matrix.
struct Sym3 {
    double xx{0}, yy{0}, zz{0}, xy{0}, xz{0}, yz{0};
    friend bool operator==(const Sym3&, const Sym3&) = default;
};

RIPRAP_HD constexpr Vec3 operator*(const Sym3& m, const Vec3& v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

RIPRAP_HD constexpr Sym3& operator+=(Sym3& a, const Sym3& b) {
    a.xx += b.xx;
    a.yy += b.yy;
    a.zz += b.zz;
    a.xy += b.xy;
    a.xz += b.xz;
    a.yz += b.yz;
    return a;
}
RIPRAP_HD constexpr Sym3 operator*(double c, const Sym3& m) {
    return {c * m.xx, c * m.yy, c * m.zz, c * m.xy, c * m.xz, c * m.yz};
}

/// sym(f r^T) = (f r^T + r f^T)/2.
RIPRAP_HD constexpr Sym3 symmetric_product(const Vec3& f, const Vec3& r) {
    return {f.x * r.x,
            f.y * r.y,
            f.z * r.z,
            0.5 * (f.x * r.y + f.y * r.x),
            0.5 * (f.x * r.z + f.z * r.x),
            0.5 * (f.y * r.z + f.z * r.y)};
}

/// A : B, the double contraction.
RIPRAP_HD constexpr double contract(const Sym3& a, const Sym3& b) {
    return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}

}  // namespace riprap
